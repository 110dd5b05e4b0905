"""The heads of functions and of blocks: ``def put_away(item):``, ``for item in objects:``, ``if …:``."""

import keyword
from dataclasses import dataclass

from app.domain.condition import Condition
from app.domain.program import ActionCall, Argument
from app.programs.cursor import Cursor
from app.programs.lexer import refuse
from app.programs.predicates import read_condition

MAX_ITEMS = 1000
MAX_PARAMETERS = 8
RESERVED = frozenset(keyword.kwlist) | {"objects", "any_of", "count", "actions"}
_LOOP = "a loop reads for item in ['lime', 'pie']: or for item in objects:"
_FILTER = "a filter reads [item for item in objects if category(item) == 'fruit']"


@dataclass(frozen=True, slots=True)
class Signature:
    """A function's name and parameters."""

    name: str
    parameters: tuple[str, ...]
    line: int


@dataclass(frozen=True, slots=True)
class LoopHead:
    """What a loop goes through; ``items`` None for the objects of the program's list."""

    variable: str
    items: tuple[Argument, ...] | None
    condition: Condition | None


def read_signature(cursor: Cursor) -> Signature:
    """The head of a function, from its ``def`` on.

    Raises:
        ProgramRefused: it is none, or its parameters are no plain names.
    """
    cursor.takes("def")
    token = cursor.take("name", "a function has a name, like def put_away():")
    cursor.expect("(", "a function reads def name():")
    parameters: list[str] = []
    for _ in cursor.items(")", "parameters stand with commas between them"):
        parameters.append(_variable(cursor, frozenset(parameters)))
    if len(parameters) > MAX_PARAMETERS:
        refuse(token.line, f"a function takes at most {MAX_PARAMETERS} parameters")
    cursor.expect(":", "a function reads def name():")
    cursor.finish("the body stands on the lines below")
    return Signature(token.text, tuple(parameters), token.line)


def read_loop(cursor: Cursor) -> LoopHead:
    """The head of a loop, after its ``for``.

    Raises:
        ProgramRefused: it goes through anything but a list of names and numbers, or the objects.
    """
    variable = _variable(cursor, cursor.variables)
    cursor.expect("in", _LOOP)
    items: tuple[Argument, ...] | None = None
    condition: Condition | None = None
    if not cursor.takes("objects"):
        cursor.expect("[", _LOOP)
        if (
            cursor.next is not None
            and cursor.next.kind == "name"
            and cursor.sees("for", distance=1)
        ):
            items, condition = _filter(cursor, variable)
        else:
            items = _items(cursor)
    _end_head(cursor)
    return LoopHead(variable, items, condition)


def read_branch(cursor: Cursor) -> Condition:
    """The head of a branch, after its ``if``.

    Raises:
        ProgramRefused: it is no condition.
    """
    condition = read_condition(cursor)
    _end_head(cursor)
    return condition


def check_helper_call(call: ActionCall, helper: Signature) -> None:
    """Whether a helper is given what it takes.

    Raises:
        ProgramRefused: too many, too few, or by a name it has not.
    """
    given = [*helper.parameters[: len(call.arguments)], *(name for name, _ in call.keywords)]
    wanted = sorted(helper.parameters)
    if len(call.arguments) > len(helper.parameters) or sorted(given) != wanted:
        shown = f"{helper.name[:80]}({', '.join(helper.parameters)})"
        refuse(call.line, f"{shown} is defined above; call it with exactly these")


def _filter(cursor: Cursor, variable: str) -> tuple[tuple[Argument, ...] | None, Condition | None]:
    """The inside of ``[each for each in objects if …]``; its variable may have another name."""
    inner = cursor.take("name", _FILTER).text
    cursor.expect("for", _FILTER)
    if cursor.take("name", _FILTER).text != inner or inner in RESERVED:
        refuse(cursor.number, _FILTER)
    cursor.expect("in", _FILTER)
    items: tuple[Argument, ...] | None = None
    if not cursor.takes("objects"):
        cursor.expect("[", _FILTER)
        items = _items(cursor)
    condition: Condition | None = None
    if cursor.takes("if"):
        outer = cursor.variables
        cursor.variables, cursor.renamed = outer | {inner}, {inner: variable}
        condition = read_condition(cursor)
        cursor.variables, cursor.renamed = outer, {}
    cursor.expect("]", _FILTER)
    return items, condition


def _items(cursor: Cursor) -> tuple[Argument, ...]:
    """The rest of a list whose opening bracket is behind."""
    wanted = "a list holds names in quotes and numbers with commas between them"
    found = tuple(cursor.argument() for _ in cursor.items("]", wanted))
    if len(found) > MAX_ITEMS:
        refuse(cursor.number, f"a loop goes through at most {MAX_ITEMS} things")
    return found


def _variable(cursor: Cursor, taken: frozenset[str]) -> str:
    token = cursor.take("name", "a variable's name is wanted")
    if token.text in RESERVED:
        refuse(token.line, f"{token.text} has a meaning of its own; call the variable otherwise")
    if token.text in taken:
        refuse(token.line, f"{token.text[:80]} is in use already; call the variable otherwise")
    return token.text


def _end_head(cursor: Cursor) -> None:
    cursor.expect(":", "the head of a block ends with a colon")
    cursor.finish("the block stands on the lines below")
