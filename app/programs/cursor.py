"""Cursor: the place in a line that a parser has come to, and what it may expect there."""

import math

from app.domain.program import Argument
from app.programs.lexer import Line, Token, refuse


class Cursor:
    """Reads one line's tokens from left to right."""

    def __init__(self, line: Line) -> None:
        self.line = line
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

    def arguments(self) -> tuple[Argument, ...]:
        """The quoted names and numbers between the brackets that follow."""
        self.expect("(", "a call reads action('object', …)")
        found: list[Argument] = []
        self.skip_comments()
        while not self.takes(")"):
            found.append(self.argument())
            self.skip_comments()
            if not self.sees(")"):
                self.expect(",", "arguments stand in quotes with commas between them")
                self.skip_comments()
        return tuple(found)

    def argument(self) -> Argument:
        """One quoted name or number."""
        token = self.next
        if token is not None and token.kind == "string":
            self.position += 1
            return token.text
        negative = self.takes("-")
        wanted = "an argument is an object's name in quotes, or a number"
        value = float(self.take("number", wanted).text)
        if not math.isfinite(value):
            refuse(self.number, "a number this large means nothing; write a smaller one")
        return -value if negative else value
