"""Calls and assertions of a program: ``assert('close' to 'lime')`` and their recoveries."""

from app.domain.program import ActionCall, Assertion
from app.programs.cursor import Cursor
from app.programs.lexer import refuse
from app.programs.predicates import read_condition


def read_assertion(cursor: Cursor, line: int) -> Assertion:
    """What follows the word assert.

    Raises:
        ProgramRefused: it is no condition, or what follows its comma is no recovery.
    """
    condition = read_condition(cursor)
    recovery = read_recovery(cursor) if cursor.takes(",") else ()
    return Assertion(condition=condition, recovery=recovery, line=line)


def read_call(cursor: Cursor) -> ActionCall:
    """The action call that comes next.

    Raises:
        ProgramRefused: it is none, or its arguments are not quoted names, numbers or variables.
    """
    line = cursor.number
    name = cursor.take("name", "a statement is a call like find('lime')").text
    arguments, keywords = cursor.arguments()
    return ActionCall(action=name, arguments=arguments, keywords=keywords, line=line)


def read_recovery(cursor: Cursor) -> tuple[ActionCall, ...]:
    """What follows the comma of an assertion: one call, or several as ``(a(), b())``."""
    if cursor.next is not None and cursor.next.kind == "string":
        refuse(cursor.number, "after the comma stands a recovery call like find('lime')")
    if not cursor.takes("("):
        return (read_call(cursor),)
    separated = "recoveries stand in brackets with commas between them"
    return tuple(read_call(cursor) for _ in cursor.items(")", separated))
