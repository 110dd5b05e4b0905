"""The conditions of a program: ``'lime' in 'bowl'``, ``'close' to 'lime'``, ``category(item) == 'fruit'``."""

from app.domain.condition import AnyOf, Condition, Count, Not, Property, Relation, all_of
from app.programs.cursor import Cursor
from app.programs.lexer import refuse

MAX_DEPTH = 8
"""Levels of ``not``, ``any_of`` and brackets in a condition."""
MAX_PARTS = 200
"""Conditions joined by one ``and`` or ``or``, or in one ``any_of``."""
HANDS = "hands"
NAME = "name"
"""The property that ``item == 'lime'`` speaks of."""
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
_COUNT = "count reads count('container', 'object', …) == 2"


def read_condition(cursor: Cursor, depth: int = 0) -> Condition:
    """The condition that comes next.

    Raises:
        ProgramRefused: it is none, or is nested deeper than ``MAX_DEPTH``.
    """
    found = [_conjunction(cursor, depth)]
    while cursor.takes("or"):
        found.append(_conjunction(cursor, depth))
        _limit(found, cursor)
    return found[0] if len(found) == 1 else AnyOf(tuple(found))


def _conjunction(cursor: Cursor, depth: int) -> Condition:
    found = [_single(cursor, depth)]
    while cursor.takes("and"):
        found.append(_single(cursor, depth))
        _limit(found, cursor)
    return all_of(*found)


def _single(cursor: Cursor, depth: int) -> Condition:
    if depth > MAX_DEPTH:
        refuse(cursor.number, f"a condition nests deeper than {MAX_DEPTH}; assert its parts")
    if cursor.takes("not"):
        return Not(_single(cursor, depth + 1))
    if cursor.takes("("):
        inner = read_condition(cursor, depth + 1)
        cursor.expect(")", "a bracket around a condition is closed after it")
        return inner
    token = cursor.next
    if token is not None and token.kind == "name" and cursor.sees("(", distance=1):
        return _named(cursor, depth)
    if token is not None and (token.kind == "string" or token.text in cursor.variables):
        return _phrase(cursor)
    refuse(
        cursor.number,
        "an assertion reads like assert('close' to 'lime'), assert('lime' in 'bowl') or "
        f"assert near('lime'), not {cursor.shown()}",
    )


def _limit(found: list[Condition], cursor: Cursor) -> None:
    if len(found) > MAX_PARTS:
        refuse(cursor.number, f"a condition has at most {MAX_PARTS} parts")


def _phrase(cursor: Cursor) -> Condition:
    first = cursor.name()
    if first in ("close", "near") and cursor.takes("to"):
        return Relation("near", (cursor.name(),))
    if cursor.takes("is"):
        negated = cursor.takes("not")
        return _signed(Relation(_state(cursor), (first,)), negated)
    if cursor.sees("==") or cursor.sees("!="):
        negated = not cursor.takes("==") and cursor.takes("!=")
        return _signed(Property(NAME, first, cursor.name()), negated)
    negated = cursor.takes("not")
    for word in INFIX:
        if cursor.takes(word):
            return _signed(_between(cursor, word, first), negated)
    refuse(
        cursor.number,
        f"between two names stands one of {', '.join(INFIX)} or is, not {cursor.shown()}",
    )


def _signed(condition: Condition, negated: bool) -> Condition:
    return Not(condition) if negated else condition


def _between(cursor: Cursor, word: str, first: str) -> Condition:
    if word == "in" and cursor.takes("["):
        names = [cursor.name() for _ in cursor.items("]", "names stand with commas between them")]
        if not names or len(names) > MAX_PARTS:
            refuse(cursor.number, f"the list holds between 1 and {MAX_PARTS} names")
        if len(names) == 1:
            return Property(NAME, first, names[0])
        return AnyOf(tuple(Property(NAME, first, name) for name in names))
    second = cursor.name()
    if word == "in" and second == HANDS:
        return Relation("held", (first,))
    return Relation(word, (first, second))


def _state(cursor: Cursor) -> str:
    line, word = cursor.number, cursor.take("string", "an object's state in quotes is wanted").text
    if word not in STATES:
        known = ", ".join(map(repr, STATES))
        refuse(line, f"after is stands one of {known}, not {word[:40]!r}")
    return STATES[word]


def _named(cursor: Cursor, depth: int) -> Condition:
    line, name = cursor.number, cursor.take("name", "a condition has a name").text.rstrip("_")
    if name == "any_of":
        return _any_of(cursor, depth)
    cursor.expect("(", f"a condition reads {name[:40]}('object')")
    separated = f"{name[:40]} speaks of objects; write their names in quotes with commas between"
    names = [
        cursor.name(f"{name[:40]} speaks of objects; write their names in quotes")
        for _ in cursor.items(")", separated)
    ]
    if name == "count":
        return _count(cursor, names)
    if not names:
        refuse(line, f"{name} speaks of no object; write {name}('object')")
    if cursor.sees("==") or cursor.sees("!="):
        return _property(cursor, name, names)
    return Relation("near" if name == "close" else name, tuple(names))


def _property(cursor: Cursor, name: str, names: list[str]) -> Condition:
    negated = not cursor.takes("==") and cursor.takes("!=")
    if len(names) != 1:
        refuse(cursor.number, f"a property reads {name[:40]}('object') == 'value'")
    truth = cursor.truth()
    value = cursor.argument() if truth is None else truth
    return _signed(Property(name, names[0], value), negated)


def _any_of(cursor: Cursor, depth: int) -> AnyOf:
    cursor.expect("(", "any_of reads any_of(condition, …)")
    found = [read_condition(cursor, depth + 1)]
    while cursor.takes(","):
        found.append(read_condition(cursor, depth + 1))
        _limit(found, cursor)
    cursor.expect(")", "any_of is closed after its last condition")
    return AnyOf(tuple(found))


def _count(cursor: Cursor, names: list[str]) -> Count:
    line = cursor.number
    cursor.expect("==", _COUNT)
    number = cursor.take("number", _COUNT).text
    if len(names) < 2 or not number.isdigit() or len(number) > 4:
        refuse(line, _COUNT)
    return Count(names[0], tuple(names[1:]), int(number))
