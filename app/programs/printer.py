"""``Program`` → text; ``parse_program`` of the text gives the program back, in both styles."""

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Literal, assert_never

from app.domain.action import ActionSignature
from app.domain.condition import AnyOf, Condition, Count, Not, Property, Relation, conjuncts
from app.domain.program import (
    ActionCall,
    Assertion,
    Branch,
    Comment,
    Loop,
    Pass,
    Program,
    Statement,
    literal,
)
from app.programs.objects import objects_line
from app.programs.predicates import HANDS, NAME

Style = Literal["paper", "python"]
INDENT = "    "

_LINE_BREAKS = re.compile("[\r\n\x00\ud800-\udfff]+")
"""What a comment may not hold."""
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
    stands above the functions where ``actions`` are given.
    """
    lines = [import_line(actions), ""] if actions else []
    for helper in program.helpers:
        lines.append(f"def {helper.name}({', '.join(helper.parameters)}):")
        lines += [*_block(helper.body, style), ""]
    lines.append(f"def {program.name}():")
    if program.objects is not None:
        lines.append(f"{INDENT}{objects_line(program.objects, program.described)}")
    return "\n".join([*lines, *_block(program.body, style)]) + "\n"


def import_line(actions: Sequence[ActionSignature]) -> str:
    """The paper's header: ``from actions import grab_and_putin(obj1, obj2)``."""
    shown = (
        f"{action.name}({', '.join(parameter.name for parameter in action.parameters)})"
        for action in actions
    )
    return f"from actions import {', '.join(shown)}"


def _block(statements: Sequence[Statement], style: Style) -> Iterator[str]:
    for statement in statements:
        for line in _lines(statement, style):
            yield f"{INDENT}{line}"


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
        case Loop(body=body):
            yield loop_head(statement)
            yield from _block(body, style)
        case Branch(condition=condition, body=body, otherwise=otherwise):
            yield f"if {_python(condition)}:"
            yield from _block(body, style)
            if otherwise:
                yield "else:"
                yield from _block(otherwise, style)
        case _:
            assert_never(statement)


def loop_head(loop: Loop) -> str:
    """``for fruit in [fruit for fruit in objects if category(fruit) == 'fruit']:``."""
    name = loop.variable
    items = "objects" if loop.items is None else f"[{', '.join(map(literal, loop.items))}]"
    if loop.condition is not None:
        items = f"[{name} for {name} in {items} if {_python(loop.condition)}]"
    return f"for {name} in {items}:"


def _assertion(assertion: Assertion, style: Style) -> Iterator[str]:
    if style == "paper":
        yield f"assert({in_words(assertion.condition)})"
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


def in_words(condition: Condition) -> str:
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
        case Relation() | Count() | Property():
            return _python(condition)
        case Not() | AnyOf():
            return _joined(condition, in_words)
        case _:
            assert_never(condition)


def _python(condition: Condition) -> str:
    match condition:
        case Relation("in", (first, second)) if second != HANDS:
            return f"{literal(first)} in {literal(second)}"
        case Relation("in", arguments):
            return f"in_({', '.join(map(literal, arguments))})"
        case Relation(name, arguments):
            return f"{name}({', '.join(map(literal, arguments))})"
        case Count(container, objects, number):
            return f"count({', '.join(map(literal, (container, *objects)))}) == {number}"
        case Property(name, subject, value):
            return _property(name, subject, value, "==")
        case Not() | AnyOf():
            return _joined(condition, _python)
        case _:
            assert_never(condition)


def _joined(condition: Not | AnyOf, write: Callable[[Condition], str]) -> str:
    parts = conjuncts(condition)
    if len(parts) > 1:
        return f"({' and '.join(map(write, parts))})"
    match condition:
        case Not(Property(name, subject, value)):
            return _property(name, subject, value, "!=")
        case Not(inner):
            return f"not {write(inner)}"
        case AnyOf(conditions):
            return f"any_of({', '.join(map(write, conditions))})"


def _property(name: str, subject: str, value: str | float, sign: str) -> str:
    if name == NAME and isinstance(value, str):
        return f"{literal(subject)} {sign} {literal(value)}"
    return f"{name}({literal(subject)}) {sign} {literal(value)}"
