"""Loops and helper calls written out: a program's body over the objects of one scene.

Properties are decided here, since they never change; what is left of a condition is decided where
the plan is carried out. A filter over relations becomes an ``if`` in every round.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import assert_never

from app.domain.condition import AnyOf, Condition, Count, Not, Property, Relation
from app.domain.program import (
    ActionCall,
    Argument,
    Assertion,
    Branch,
    Comment,
    Helper,
    Loop,
    Pass,
    Program,
    Statement,
    Variable,
)
from app.domain.scene import Scene
from app.programs.lexer import refuse
from app.programs.properties import Properties

MAX_STATEMENTS = 2000
"""Of a program written out."""
MAX_ROUNDS = 20_000
"""Of all its loops and helpers together."""

Scope = Mapping[str, Argument]


def unroll(program: Program, scene: Scene) -> tuple[Statement, ...]:
    """The task's body without loops and helper calls.

    Raises:
        ProgramRefused: it would hold more than ``MAX_STATEMENTS``.
    """
    return tuple(_Unrolling(program, scene).body(program.body, {}))


class _Unrolling:
    def __init__(self, program: Program, scene: Scene) -> None:
        self._objects = scene.names if program.objects is None else program.objects
        self._helpers = {helper.name: helper for helper in program.helpers}
        self._properties = Properties(scene, program.described)
        self._statements = 0
        self._rounds = 0

    def body(self, statements: Sequence[Statement], scope: Scope) -> Iterator[Statement]:
        for statement in statements:
            self._rounds += 1
            if self._rounds > MAX_ROUNDS:
                self._refuse(statement.line)
            for each in self._statement(statement, scope):
                self._statements += 1
                if self._statements > MAX_STATEMENTS:
                    self._refuse(statement.line)
                yield each

    def _refuse(self, line: int) -> None:
        refuse(line, f"written out, the plan has more than {MAX_STATEMENTS} statements; shorten it")

    def _statement(self, statement: Statement, scope: Scope) -> Iterator[Statement]:
        match statement:
            case Comment() | Pass():
                yield statement
            case ActionCall():
                yield from self._call(_put_in_call(statement, scope))
            case Assertion():
                yield from self._assertion(statement, scope)
            case Branch():
                yield from self._branch(statement, scope)
            case Loop():
                yield from self._loop(statement, scope)
            case _:
                assert_never(statement)

    def _call(self, call: ActionCall) -> Iterator[Statement]:
        helper = self._helpers.get(call.action)
        if helper is None:
            yield call
        else:
            earlier = self._helpers
            self._helpers = _before(helper, earlier)
            scope = {
                **dict(zip(helper.parameters, call.arguments, strict=False)),
                **dict(call.keywords),
            }
            yield from self.body(helper.body, scope)
            self._helpers = earlier

    def _assertion(self, assertion: Assertion, scope: Scope) -> Iterator[Statement]:
        condition = self._decided(assertion.condition, scope)
        recovery = tuple(_put_in_call(call, scope) for call in assertion.recovery)
        if not isinstance(condition, bool):
            yield replace(assertion, condition=condition, recovery=recovery)
        elif not condition:
            yield from recovery

    def _branch(self, branch: Branch, scope: Scope) -> Iterator[Statement]:
        condition = self._decided(branch.condition, scope)
        if isinstance(condition, bool):
            yield from self.body(branch.body if condition else branch.otherwise, scope)
            return
        body = tuple(self.body(branch.body, scope))
        otherwise = tuple(self.body(branch.otherwise, scope))
        yield Branch(
            condition=condition,
            body=_saying_something(body, branch.line),
            otherwise=_saying_something(otherwise, branch.line) if otherwise else (),
            line=branch.line,
        )

    def _loop(self, loop: Loop, scope: Scope) -> Iterator[Statement]:
        for item in self._objects if loop.items is None else loop.items:
            inner = {**scope, loop.variable: _put_in(item, scope)}
            if loop.condition is None:
                yield from self.body(loop.body, inner)
            else:
                once = Branch(condition=loop.condition, body=loop.body, line=loop.line)
                yield from self.body((once,), inner)

    def _decided(self, condition: Condition, scope: Scope) -> Condition | bool:
        """What is left of the condition where its properties are decided."""
        put_in = _put_in_condition(condition, scope)
        return self._properties.decide(put_in)


def _before(helper: Helper, helpers: dict[str, Helper]) -> dict[str, Helper]:
    """Those it may call: the ones above it."""
    above: dict[str, Helper] = {}
    for name, each in helpers.items():
        if each is helper:
            break
        above[name] = each
    return above


def _saying_something(body: tuple[Statement, ...], line: int) -> tuple[Statement, ...]:
    empty = all(isinstance(each, Comment) for each in body)
    return (*body, Pass(line=line)) if empty else body


def _put_in(value: Argument, scope: Scope) -> Argument:
    """The argument with what its variable stands for."""
    if not isinstance(value, Variable):
        return value
    found = scope[str(value)]
    if not value.offset:
        return found
    if isinstance(found, str):  # No number: an object of such a name is looked for, in vain.
        return f"{found} + {value.offset}"
    return round(found + value.offset, 9)


def _put_in_name(name: str, scope: Scope) -> str:
    found = _put_in(name, scope)
    return found if isinstance(found, str) else f"{found:g}"


def _put_in_call(call: ActionCall, scope: Scope) -> ActionCall:
    return replace(
        call,
        arguments=tuple(_put_in(value, scope) for value in call.arguments),
        keywords=tuple((name, _put_in(value, scope)) for name, value in call.keywords),
    )


def _put_in_condition(condition: Condition, scope: Scope) -> Condition:
    match condition:
        case Relation(name, arguments):
            return Relation(name, tuple(_put_in_name(each, scope) for each in arguments))
        case Not(inner):
            return Not(_put_in_condition(inner, scope))
        case AnyOf(conditions):
            return AnyOf(tuple(_put_in_condition(each, scope) for each in conditions))
        case Count(container, objects, number):
            names = tuple(_put_in_name(each, scope) for each in objects)
            return Count(_put_in_name(container, scope), names, number)
        case Property(name, subject, value):
            known = value if isinstance(value, bool) else _put_in(value, scope)
            return Property(name, _put_in_name(subject, scope), known)
        case _:
            assert_never(condition)
