"""Text ↔ ``Sketch``; never eval, and what is outside the form is refused."""

from app.domain.errors import Fault, ProgramRefused
from app.programs.cursor import Cursor
from app.programs.lexer import read_lines, refuse
from app.programs.printer import INDENT
from app.programs.sketches.sketch import (
    RELATIONS,
    Decline,
    Each,
    Phrase,
    Previous,
    Rest,
    Same,
    Sketch,
    SketchArgument,
    SketchCall,
    SketchStatement,
)

MAX_STATEMENTS = 40
MAX_ARGUMENTS = 8
MAX_PHRASE = 300
"""Characters."""
MAX_LEFT_OUT = 20
MAX_COUNT = 99
_WANTED = (
    "an argument is words in quotes, one(…), all(…), rest, same(…), each(…), previous or a number"
)


def parse_sketch(text: str) -> Sketch:
    """Read the body of a sketch, one statement a line; indentation and comments do not count.

    Raises:
        ProgramRefused: it is empty, longer than ``MAX_STATEMENTS``, or holds anything else.
    """
    body: list[SketchStatement] = []
    for line in read_lines(text):
        cursor = Cursor(line)
        cursor.skip_comments()
        if cursor.next is None:
            continue
        if len(body) == MAX_STATEMENTS:
            refuse(line.number, f"a sketch has at most {MAX_STATEMENTS} lines")
        body.append(_statement(cursor))
        cursor.finish("a call ends its line")
    if not body:
        raise ProgramRefused(Fault(field="program", message="is empty; write at least one call"))
    return Sketch(tuple(body))


def print_sketch(sketch: Sketch) -> str:
    """The sketch as indented lines; ``parse_sketch`` gives it back."""
    return "".join(f"{INDENT}{statement}\n" for statement in sketch.body)


def _statement(cursor: Cursor) -> SketchStatement:
    name = cursor.take("name", "a line is a call like grab_and_putin('pear', 'bowl')").text
    cursor.expect("(", "a call reads action('words', …)")
    if name == "decline":
        reason = _words(cursor)
        cursor.expect(")", "decline('impossible') has one word")
        return Decline(reason)
    arguments: list[SketchArgument] = []
    while not cursor.takes(")"):
        if len(arguments) == MAX_ARGUMENTS:
            refuse(cursor.number, f"a call has at most {MAX_ARGUMENTS} arguments")
        arguments.append(_argument(cursor))
        if not cursor.sees(")"):
            cursor.expect(",", "commas stand between arguments")
    return SketchCall(name, tuple(arguments))


def _argument(cursor: Cursor) -> SketchArgument:
    token = cursor.next
    if token is None or token.kind != "name":
        value = cursor.argument()
        return Phrase(text=_checked(value, cursor)) if isinstance(value, str) else float(value)
    cursor.position += 1
    match token.text:
        case "rest":
            return Rest()
        case "previous":
            return Previous()
        case "one" | "all":
            return _phrase(cursor, token.text)
        case "same":
            return _same(cursor)
        case "each":
            return _each(cursor)
        case _:
            refuse(token.line, f"{_WANTED}, not {token.text[:40]!r}")


def _phrase(cursor: Cursor, quantity: str) -> Phrase:
    cursor.expect("(", f"{quantity} reads {quantity}('words', …)")
    text = _words(cursor)
    but: tuple[str, ...] = ()
    count: int | None = None
    named: dict[str, str] = {}
    while not cursor.takes(")"):
        cursor.expect(",", f"commas stand between what {quantity}(…) is given")
        line, key = cursor.number, cursor.take("name", "a keyword like but= or where= follows").text
        cursor.expect("=", f"{key[:40]!r} is given as {key[:40]}=…")
        if key in named or (key == "but" and but) or (key == "count" and count is not None):
            refuse(line, f"{key} is given twice")
        if key == "but":
            but = _several(cursor)
        elif key == "count":
            count = _count(cursor)
        elif key in ("where", "order", *RELATIONS):
            named[key] = _words(cursor)
        else:
            known = ", ".join(("but", "count", "where", "order", *RELATIONS))
            refuse(line, f"there is no keyword {key[:40]!r}; there are {known}")
    return Phrase(
        text=text,
        quantity="all" if quantity == "all" else "one",
        but=but,
        count=count,
        where=named.get("where"),
        order=named.get("order"),
        relations=tuple((key, named[key]) for key in RELATIONS if key in named),
    )


def _same(cursor: Cursor) -> Same:
    cursor.expect("(", "same reads same('colour', 'bowls')")
    shared = _words(cursor)
    cursor.expect(",", "same reads same('colour', 'bowls')")
    text = _words(cursor)
    cursor.expect(")", "same reads same('colour', 'bowls')")
    return Same(shared, text)


def _each(cursor: Cursor) -> Each:
    cursor.expect("(", "each reads each('bowls')")
    text, count = _words(cursor), 1
    if cursor.takes(","):
        for part in ("count", "="):
            cursor.expect(part, "each reads each('bowls', count=2)")
        count = _count(cursor)
    cursor.expect(")", "each reads each('bowls')")
    return Each(text, count)


def _several(cursor: Cursor) -> tuple[str, ...]:
    """Words, or a list of words."""
    if not cursor.takes("["):
        return (_words(cursor),)
    found = [_words(cursor)]
    while not cursor.takes("]"):
        cursor.expect(",", "commas stand between what is left out")
        if len(found) == MAX_LEFT_OUT:
            refuse(cursor.number, f"at most {MAX_LEFT_OUT} are left out")
        found.append(_words(cursor))
    return tuple(found)


def _count(cursor: Cursor) -> int:
    line, text = cursor.number, cursor.take("number", "a count is a whole number").text
    if not text.isascii() or not text.isdigit() or len(text) > 2 or not 0 < int(text) <= MAX_COUNT:
        refuse(line, f"a count is a whole number from 1 to {MAX_COUNT}")
    return int(text)


def _words(cursor: Cursor) -> str:
    return _checked(cursor.take("string", "words in quotes are wanted").text, cursor)


def _checked(text: str, cursor: Cursor) -> str:
    if not text.strip():
        refuse(cursor.number, "words in quotes are wanted, not an empty string")
    if len(text) > MAX_PHRASE:
        refuse(cursor.number, f"words have at most {MAX_PHRASE} characters")
    return text
