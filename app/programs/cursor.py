"""Cursor: the place in a line that a parser has come to, and what it may expect there."""

import math
from collections.abc import Iterator

from app.domain.program import Argument, Variable
from app.programs.lexer import Line, Token, refuse


class Cursor:
    """Reads one line's tokens from left to right."""

    def __init__(self, line: Line, variables: frozenset[str] = frozenset()) -> None:
        self.line = line
        self.variables = variables
        """The names that stand for an object or a number here."""
        self.renamed: dict[str, str] = {}
        """What some of them are called where they come to stand."""
        self.position = 0

    @property
    def next(self) -> Token | None:
        """The token that comes next, or None at the end of the line."""
        return self.ahead(0)

    @property
    def number(self) -> int:
        """The line of text the next token stands on."""
        return self.next.line if self.next else self.line.number

    def ahead(self, distance: int) -> Token | None:
        """The token so many places further on."""
        place = self.position + distance
        return self.line.tokens[place] if place < len(self.line.tokens) else None

    def sees(self, text: str, *, distance: int = 0) -> bool:
        """Whether the token so many places on is this name or symbol."""
        token = self.ahead(distance)
        return token is not None and token.kind in ("name", "symbol") and token.text == text

    def takes(self, text: str) -> bool:
        """Step over this name or symbol if it comes next."""
        if self.sees(text):
            self.position += 1
            return True
        return False

    def expect(self, text: str, message: str) -> None:
        """Step over this name or symbol, which must come next."""
        if not self.takes(text):
            refuse(self.number, f"{message}, not {self.shown()}")

    def take(self, kind: str, message: str) -> Token:
        """The next token, which must be of this kind."""
        token = self.next
        if token is None or token.kind != kind:
            refuse(self.number, f"{message}, not {self.shown()}")
        self.position += 1
        return token

    def finish(self, message: str) -> None:
        """Nothing but a comment may follow."""
        if self.next is not None and self.next.kind != "comment":
            refuse(self.number, f"{message}; remove {self.shown()}")

    def shown(self) -> str:
        """What comes next, for a message."""
        if self.next is None:
            return "the end of the line"
        text = self.next.text if len(self.next.text) <= 40 else f"{self.next.text[:40]}…"
        return repr(text)

    def skip_comments(self) -> None:
        """Step over comments inside brackets."""
        while self.next is not None and self.next.kind == "comment":
            self.position += 1

    def items(self, close: str, wanted: str) -> Iterator[None]:
        """Stand at each item of a list in turn, up to the bracket that closes it."""
        self.skip_comments()
        while not self.takes(close):
            yield
            self.skip_comments()
            if not self.sees(close):
                self.expect(",", wanted)
                self.skip_comments()

    def arguments(self) -> tuple[tuple[Argument, ...], tuple[tuple[str, Argument], ...]]:
        """What stands between the brackets that follow: in order, and by name after that."""
        self.expect("(", "a call reads action('object', …)")
        found: list[Argument] = []
        named: dict[str, Argument] = {}
        for _ in self.items(")", "arguments stand in quotes with commas between them"):
            token = self.next
            if token is not None and token.kind == "name" and self.sees("=", distance=1):
                self.position += 2
                if token.text in named:
                    refuse(token.line, f"{token.text} is given twice")
                named[token.text] = self.argument()
            elif named:
                refuse(self.number, "an argument without a name stands before those with one")
            else:
                found.append(self.argument())
        return tuple(found), tuple(named.items())

    def argument(self) -> Argument:
        """One quoted name, number, or variable in scope with or without an offset."""
        token = self.next
        if token is not None and token.kind == "string":
            self.position += 1
            return token.text
        if token is not None and token.kind == "name" and token.text in self.variables:
            self.position += 1
            return Variable(self.renamed.get(token.text, token.text), self._sum(0.0))
        wanted = "an argument is an object's name in quotes, or a number"
        negative = self.takes("-")
        value = self._number(wanted)
        return self._sum(-value if negative else value)

    def name(self, wanted: str = "an object's name in quotes is wanted") -> str:
        """One quoted name, or variable in scope."""
        token = self.next
        if token is not None and token.kind == "name" and token.text in self.variables:
            self.position += 1
            return Variable(self.renamed.get(token.text, token.text))
        return self.take("string", wanted).text

    def truth(self) -> bool | None:
        """True or False, if one of them comes next."""
        for value in (True, False):
            if self.takes(str(value)):
                return value
        return None

    def _sum(self, start: float) -> float:
        """The number, with those added and taken away that follow."""
        value, terms = start, 0
        while self.sees("+") or self.sees("-"):
            negative = self.takes("-") or not self.takes("+")
            number = self._number("a number is added or taken away")
            value += -number if negative else number
            terms += 1
        if not math.isfinite(value):
            refuse(self.number, "a number this large means nothing; write a smaller one")
        return _rounded(value) if terms else value

    def _number(self, wanted: str) -> float:
        value = float(self.take("number", wanted).text)
        if not math.isfinite(value):
            refuse(self.number, "a number this large means nothing; write a smaller one")
        return value


def _rounded(value: float) -> float:
    """Without what adding decimal fractions leaves behind."""
    return round(value, 9)
