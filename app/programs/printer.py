"""``Program`` → text; ``parse_program`` of the text gives the program back, in both styles."""

import re
from collections.abc import Iterator, Sequence
from typing import Literal, assert_never

from app.domain.action import ActionSignature
from app.domain.condition import AnyOf, Condition, Count, Not, Relation
from app.domain.program import ActionCall, Assertion, Comment, Pass, Program, Statement, literal
from app.programs.assertions import HANDS

Style = Literal["paper", "python"]
INDENT = "    "

_LINE_BREAKS = re.compile(r"[\r\n]+")
_STATES = {
    "open": "opened",
    "closed": "closed",
    "switched_on": "switchon",
    "switched_off": "switchoff",
}


def print_program(
    program: Program, style: Style = "paper", actions: Sequence[ActionSignature] | None = None
) -> str:
    """The program's text.

    ``paper`` writes assertions as the paper does, ``python`` as valid Python. The import line
    stands above the function where ``actions`` are given.
    """
    lines = [import_line(actions), ""] if actions else []
    lines.append(f"def {program.name}():")
    if program.objects is not None:
        lines.append(f"{INDENT}{objects_line(program.objects)}")
    for statement in program.body:
        lines += [f"{INDENT}{line}" for line in _lines(statement, style)]
    return "\n".join(lines) + "\n"


def import_line(actions: Sequence[ActionSignature]) -> str:
    """The paper's header: ``from actions import grab_and_putin(obj1, obj2)``."""
    shown = (
        f"{action.name}({', '.join(parameter.name for parameter in action.parameters)})"
        for action in actions
    )
    return f"from actions import {', '.join(shown)}"


def objects_line(names: Sequence[str]) -> str:
    """The objects as a list of strings: ``objects = ['lime', 'bowl']``."""
    return f"objects = [{', '.join(map(literal, names))}]"


def _lines(statement: Statement, style: Style) -> Iterator[str]:
    match statement:
        case Comment(text=text):
            yield f"# {_LINE_BREAKS.sub(' ', text)}".rstrip()
        case ActionCall():
            yield str(statement)
        case Assertion():
            yield from _assertion(statement, style)
        case Pass():
            yield "pass"
        case _:
            assert_never(statement)


def _assertion(assertion: Assertion, style: Style) -> Iterator[str]:
    if style == "paper":
        yield f"assert({_phrase(assertion.condition)})"
        for call in assertion.recovery:
            yield f"{INDENT}else: {call}"
        return
    condition = f"assert {_python(assertion.condition)}"
    match assertion.recovery:
        case ():
            yield condition
        case (call,):
            yield f"{condition}, {call}"
        case calls:
            yield f"{condition}, ({', '.join(map(str, calls))})"


def _phrase(condition: Condition) -> str:
    """The condition in the paper's words, where it has words for it."""
    match condition:
        case Relation("near", (only,)):
            return f"'close' to {literal(only)}"
        case Relation("held", (only,)):
            return f"{literal(only)} in '{HANDS}'"
        case Relation(name, (only,)) if name in _STATES:
            return f"{literal(only)} is '{_STATES[name]}'"
        case Relation("on", (first, second)):
            return f"{literal(first)} on {literal(second)}"
        case Not(inner):
            return f"not {_phrase(inner)}"
        case AnyOf(conditions):
            return f"any_of({', '.join(map(_phrase, conditions))})"
        case _:
            return _python(condition)


def _python(condition: Condition) -> str:
    match condition:
        case Relation("in", (first, second)) if second != HANDS:
            return f"{literal(first)} in {literal(second)}"
        case Relation("in", arguments):
            return f"in_({', '.join(map(literal, arguments))})"
        case Relation(name, arguments):
            return f"{name}({', '.join(map(literal, arguments))})"
        case Not(inner):
            return f"not {_python(inner)}"
        case AnyOf(conditions):
            return f"any_of({', '.join(map(_python, conditions))})"
        case Count(container, objects, number):
            return f"count({', '.join(map(literal, (container, *objects)))}) == {number}"
        case _:
            assert_never(condition)
