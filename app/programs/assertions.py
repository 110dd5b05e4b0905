"""Assertions of a program: ``assert('close' to 'lime')`` and their recoveries."""

from app.domain.condition import AnyOf, Condition, Count, Not, Relation
from app.domain.program import ActionCall
from app.programs.cursor import Cursor
from app.programs.lexer import refuse

MAX_DEPTH = 8
"""Levels of ``not``, ``any_of`` and brackets in a condition."""
HANDS = "hands"
STATES = {
    "open": "open",
    "opened": "open",
    "closed": "closed",
    "close": "closed",
    "switched on": "switched_on",
    "switchedon": "switched_on",
    "switchon": "switched_on",
    "on": "switched_on",
    "switched off": "switched_off",
    "switchedoff": "switched_off",
    "switchoff": "switched_off",
    "off": "switched_off",
    "held": "held",
    "upright": "upright",
    "heated": "heated",
    "washed": "washed",
    "used": "used",
}
"""What may stand after ``is``, and the relation it means."""
INFIX = ("in", "on", "near", "left_of", "right_of")


def read_condition(cursor: Cursor, depth: int = 0) -> Condition:
    """The condition that comes next.

    Raises:
        ProgramRefused: it is none, or is nested deeper than ``MAX_DEPTH``.
    """
    if depth > MAX_DEPTH:
        refuse(cursor.number, f"a condition nests deeper than {MAX_DEPTH}; assert its parts")
    if cursor.takes("not"):
        return Not(read_condition(cursor, depth + 1))
    if cursor.takes("("):
        inner = read_condition(cursor, depth + 1)
        cursor.expect(")", "a bracket around a condition is closed after it")
        return inner
    token = cursor.next
    if token is not None and token.kind == "string":
        return _phrase(cursor)
    if token is not None and token.kind == "name" and cursor.sees("(", distance=1):
        return _named(cursor, depth)
    refuse(
        cursor.number,
        "an assertion reads like assert('close' to 'lime'), assert('lime' in 'bowl') or "
        f"assert near('lime'), not {cursor.shown()}",
    )


def _phrase(cursor: Cursor) -> Condition:
    first = _name(cursor)
    if first in ("close", "near") and cursor.takes("to"):
        return Relation("near", (_name(cursor),))
    if cursor.takes("is"):
        negated = cursor.takes("not")
        relation = Relation(_state(cursor), (first,))
        return Not(relation) if negated else relation
    negated = cursor.takes("not")
    for word in INFIX:
        if cursor.takes(word):
            relation = _between(word, first, _name(cursor))
            return Not(relation) if negated else relation
    refuse(
        cursor.number,
        f"between two names stands one of {', '.join(INFIX)} or is, not {cursor.shown()}",
    )


def _between(word: str, first: str, second: str) -> Relation:
    if word == "in" and second == HANDS:
        return Relation("held", (first,))
    return Relation(word, (first, second))


def _state(cursor: Cursor) -> str:
    line, word = cursor.number, _name(cursor)
    if word not in STATES:
        known = ", ".join(map(repr, STATES))
        refuse(line, f"after is stands one of {known}, not {word[:40]!r}")
    return STATES[word]


def _named(cursor: Cursor, depth: int) -> Condition:
    line, name = cursor.number, cursor.take("name", "a condition has a name").text.rstrip("_")
    if name == "any_of":
        return _any_of(cursor, depth)
    arguments: list[str] = []
    for argument in cursor.arguments():
        if not isinstance(argument, str):
            refuse(line, f"{name} speaks of objects; write their names in quotes")
        arguments.append(argument)
    if name == "count":
        return _count(cursor, arguments)
    if not arguments:
        refuse(line, f"{name} speaks of no object; write {name}('object')")
    return Relation("near" if name == "close" else name, tuple(arguments))


def _any_of(cursor: Cursor, depth: int) -> AnyOf:
    cursor.expect("(", "any_of reads any_of(condition, …)")
    found = [read_condition(cursor, depth + 1)]
    while cursor.takes(","):
        found.append(read_condition(cursor, depth + 1))
    cursor.expect(")", "any_of is closed after its last condition")
    return AnyOf(tuple(found))


def _count(cursor: Cursor, arguments: list[str]) -> Count:
    line = cursor.number
    wanted = "count reads count('container', 'object', …) == 2"
    cursor.expect("==", wanted)
    number = cursor.take("number", wanted).text
    if len(arguments) < 2 or not number.isdigit() or len(number) > 4:
        refuse(line, wanted)
    return Count(arguments[0], tuple(arguments[1:]), int(number))


def _name(cursor: Cursor) -> str:
    return cursor.take("string", "an object's name in quotes is wanted").text


def read_call(cursor: Cursor) -> ActionCall:
    """The action call that comes next.

    Raises:
        ProgramRefused: it is none, or its arguments are not quoted names and numbers.
    """
    line = cursor.number
    name = cursor.take("name", "a statement is a call like find('lime')").text
    return ActionCall(action=name, arguments=cursor.arguments(), line=line)


def read_recovery(cursor: Cursor) -> tuple[ActionCall, ...]:
    """What follows the comma of an assertion: one call, or several as ``(a(), b())``."""
    if cursor.next is not None and cursor.next.kind == "string":
        refuse(cursor.number, "after the comma stands a recovery call like find('lime')")
    if not cursor.takes("("):
        return (read_call(cursor),)
    calls: list[ActionCall] = []
    cursor.skip_comments()
    while not cursor.takes(")"):
        calls.append(read_call(cursor))
        cursor.skip_comments()
        if not cursor.sees(")"):
            cursor.expect(",", "recoveries stand in brackets with commas between them")
            cursor.skip_comments()
    return tuple(calls)
