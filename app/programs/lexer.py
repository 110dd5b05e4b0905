"""Program text → lines of tokens; linear in the length of the text, and bounded in depth."""

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NoReturn

from app.domain.errors import Fault, ProgramRefused

MAX_CHARACTERS = 100_000
MAX_BRACKET_DEPTH = 8
TAB = 8
"""Columns a tab advances to a multiple of, as in Python."""

Kind = Literal["name", "number", "string", "comment", "symbol"]

# Strings without possessive quantifiers: Python 3.11.2, as Debian 12 has it, gets those wrong.
_SCANNER = re.compile(
    r"""
    (?P<space>   [ \t\f]+ )
  | (?P<comment> \#[^\n]* )
  | (?P<string>  \"\"\" [^"\\]* (?: (?: \\[\s\S] | "(?!"") ) [^"\\]* )* \"\"\"
               | ''' [^'\\]* (?: (?: \\[\s\S] | '(?!'') ) [^'\\]* )* '''
               | " [^"\\\n]* (?: \\[\s\S] [^"\\\n]* )* "
               | ' [^'\\\n]* (?: \\[\s\S] [^'\\\n]* )* ' )
  | (?P<number>  (?: [0-9]+ (?: \.[0-9]* )? | \.[0-9]+ ) (?: [eE][+-]?[0-9]+ )? (?! \w ) )
  | (?P<name>    [^\W\d]\w* )
  | (?P<newline> \n )
  | (?P<symbol>  == | != | -> | [()\[\]{},:=+\-<>.] )
    """,
    re.VERBOSE,
)

_UNSTORABLE = re.compile("[\x00\ud800-\udfff]")
_ESCAPE = re.compile(
    r"\\(?:x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|([0-7]{1,3})|([\s\S]))"
)
_NAMED_ESCAPES = {
    "a": "\a",
    "b": "\b",
    "f": "\f",
    "n": "\n",
    "r": "\r",
    "t": "\t",
    "v": "\v",
    "\\": "\\",
    "'": "'",
    '"': '"',
    "\n": "",
}


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of a line; ``text`` of a string is what it stands for, of a comment what it says."""

    kind: Kind
    text: str
    line: int


@dataclass(frozen=True, slots=True)
class Line:
    """A logical line: brackets may carry it over several lines of text."""

    number: int
    """1-based, where it begins."""
    indent: int
    """Columns before its first token."""
    tokens: tuple[Token, ...]


def refuse(line: int, message: str) -> NoReturn:
    """Refuse the program because of one of its lines.

    Raises:
        ProgramRefused: always.
    """
    raise ProgramRefused(Fault(field=f"program.line {line}", message=message))


def read_lines(text: str) -> Iterator[Line]:
    """The lines that hold anything, in order.

    Raises:
        ProgramRefused: the text is too long, holds a character the language has no use for, leaves
            a string or bracket open, or nests brackets deeper than ``MAX_BRACKET_DEPTH``.
    """
    if len(text) > MAX_CHARACTERS:
        message = f"has {len(text)} characters; at most {MAX_CHARACTERS} are taken"
        raise ProgramRefused(Fault(field="program", message=message))
    _refuse_unstorable(text)
    tokens: list[Token] = []
    open_lines: list[int] = []
    indent = 0
    for token, column in _scan(text.replace("\r\n", "\n").replace("\r", "\n")):
        if token.text == "\n" and token.kind == "symbol":
            if tokens and not open_lines:
                yield Line(tokens[0].line, indent, tuple(tokens))
                tokens = []
            continue
        if not tokens:
            indent = column
        tokens.append(token)
        _follow_brackets(token, open_lines)
    if open_lines:
        refuse(open_lines[-1], "a bracket opened here is never closed; add the closing one")
    if tokens:
        yield Line(tokens[0].line, indent, tuple(tokens))


def _refuse_unstorable(text: str) -> None:
    if found := _UNSTORABLE.search(text):
        refuse(text.count("\n", 0, found.start()) + 1, "a NUL or half a surrogate pair; remove it")


def _follow_brackets(token: Token, open_lines: list[int]) -> None:
    if token.kind != "symbol":
        return
    if token.text in "([{":
        open_lines.append(token.line)
        if len(open_lines) > MAX_BRACKET_DEPTH:
            refuse(token.line, f"brackets nest deeper than {MAX_BRACKET_DEPTH}; write plain calls")
    elif token.text in ")]}":
        if not open_lines:
            refuse(token.line, f"{token.text!r} closes nothing; remove it")
        open_lines.pop()


def _scan(text: str) -> Iterator[tuple[Token, int]]:
    """Every token but space, ends of lines included, each with its line's indentation."""
    position, line, indent = 0, 1, 0
    fresh = True
    while position < len(text):
        match = _SCANNER.match(text, position)
        if match is None or _opens_triple(match, text):
            _refuse_character(text, position, line)
        kind, found = match.lastgroup, match.group()
        position = match.end()
        if kind == "space":
            indent = len(found.expandtabs(TAB)) if fresh else indent
        else:
            yield _token(kind, found, line), indent
        fresh = kind == "newline"
        indent = 0 if fresh else indent
        line += found.count("\n")


def _opens_triple(match: re.Match[str], text: str) -> bool:
    """Whether what looks like an empty string opens a triple-quoted one that never ends."""
    return match.group() in ('""', "''") and text[match.end() : match.end() + 1] == match.group()[0]


def _token(kind: str | None, found: str, line: int) -> Token:
    match kind:
        case "comment":
            return Token("comment", found[1:].strip(), line)
        case "string":
            return Token("string", _decode(found, line), line)
        case "number" | "name":
            return Token(kind, found, line)
        case _:
            return Token("symbol", found, line)


def _refuse_character(text: str, position: int, line: int) -> NoReturn:
    character = text[position]
    if character in "'\"":
        refuse(line, f"a string opened with {character} is never closed; close it on its line")
    if character.isdigit():
        refuse(line, "a number is written like 3, 0.25 or 1e-3")
    shown = character if character.isprintable() else f"character {ord(character):#06x}"
    refuse(line, f"{shown!r} has no place in the plan language; write calls on quoted names")


def _decode(quoted: str, line: int) -> str:
    width = 3 if quoted[:3] in ('"""', "'''") else 1
    value = _ESCAPE.sub(lambda match: _character(match, line), quoted[width:-width])
    if any(unicodedata.category(character) == "Cs" for character in value):
        refuse(line, "a string holds half of a surrogate pair; write the character itself")
    return value


def _character(match: re.Match[str], line: int) -> str:
    hexadecimal = match[1] or match[2] or match[3]
    if hexadecimal or match[4]:
        code = int(hexadecimal, 16) if hexadecimal else int(match[4], 8)
        if code > 0x10FFFF:
            refuse(line, f"{match[0]} is no character; the last one is \\U0010ffff")
        return chr(code)
    if match[5] in "NuUx":
        refuse(line, f"the escape {match[0]!r} is incomplete or unknown; write the character")
    return _NAMED_ESCAPES.get(match[5], match[0])
