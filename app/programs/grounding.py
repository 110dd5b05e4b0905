"""Program + scene → ``Plan``: what names something that is not there becomes a rejected call."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import assert_never

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import AnyOf, Condition, Not, Property
from app.domain.condition import relations as relations_of
from app.domain.plan import (
    Call,
    GroundedAssertion,
    GroundedBranch,
    GroundedCall,
    Jump,
    Plan,
    RejectedCall,
    Step,
)
from app.domain.program import (
    ActionCall,
    Argument,
    Assertion,
    Branch,
    Comment,
    Loop,
    Pass,
    Program,
    Statement,
)
from app.domain.scene import Scene
from app.programs.conditions import nearest, print_condition
from app.programs.unrolling import unroll

MAX_SUGGESTIONS = 50
"""So many different unknown names are compared with the known ones; it takes time."""


def ground(
    program: Program,
    scene: Scene,
    actions: Iterable[ActionSignature],
    relations: Mapping[str, int] | None = None,
) -> Plan:
    """The program's statements as steps over the scene's objects and the actions on offer.

    ``relations`` are those the world can decide, by number of objects; where they are given, an
    assertion of any other is rejected.

    Raises:
        ProgramRefused: with its loops and helpers written out it is too long.
    """
    grounding = _Grounding(scene, actions, relations)
    return Plan(steps=tuple(grounding.steps(unroll(program, scene))))


class _Grounding:
    """What a program may name."""

    def __init__(
        self,
        scene: Scene,
        actions: Iterable[ActionSignature],
        relations: Mapping[str, int] | None,
    ) -> None:
        self._names = frozenset(scene.names)
        # Only where somebody acts in a home an object stands for all of its class.
        of_classes = scene.objects if scene.agent is not None else ()
        self._single = frozenset(name for item in of_classes for name in item.members())
        self._agent = scene.agent
        self._actions = {action.name: action for action in actions}
        self._relations = relations
        self._hints: dict[str, str] = {}
        self._comment: str | None = None
        """The comment that was passed last."""

    def steps(self, statements: Sequence[Statement]) -> Iterator[Step]:
        """The steps of unrolled statements; of a branch, those of both sides one after the other."""
        for statement in statements:
            match statement:
                case Comment(text=text):
                    self._comment = text
                    yield statement
                case ActionCall():
                    yield self._call(statement)
                case Assertion():
                    yield self._assertion(statement)
                case Branch():
                    yield from self._branch(statement)
                case Pass():
                    pass
                case Loop():
                    raise AssertionError("loops are unrolled before they are grounded")
                case _:
                    assert_never(statement)

    def _call(self, call: ActionCall) -> Call:
        bound = self._bound(call)
        reason = bound if isinstance(bound, str) else self._call_fault(call, bound)
        if isinstance(bound, str) or reason is not None:
            return RejectedCall(line=call.line, text=str(call), reason=reason or "")
        return GroundedCall(
            line=call.line, action=call.action, arguments=bound, comment=self._comment
        )

    def _assertion(self, assertion: Assertion) -> Step:
        reason = self._condition_fault(assertion.condition)
        if reason:
            text = f"assert {print_condition(assertion.condition)}"
            return RejectedCall(line=assertion.line, text=text, reason=reason)
        recovery = tuple(self._call(call) for call in assertion.recovery)
        return GroundedAssertion(
            line=assertion.line, condition=assertion.condition, recovery=recovery
        )

    def _branch(self, branch: Branch) -> Iterator[Step]:
        reason = self._condition_fault(branch.condition)
        if reason:
            text = f"if {print_condition(branch.condition)}"
            yield RejectedCall(line=branch.line, text=text, reason=reason)
            return
        body = tuple(self.steps(branch.body))
        otherwise = tuple(self.steps(branch.otherwise))
        jump = (Jump(skip=len(otherwise)),) if otherwise else ()
        yield GroundedBranch(
            line=branch.line, condition=branch.condition, skip=len(body) + len(jump)
        )
        yield from (*body, *jump, *otherwise)

    def _bound(self, call: ActionCall) -> tuple[Argument, ...] | str:
        """The arguments in the order of the parameters, or why they do not fit."""
        action = self._actions.get(call.action)
        if action is None:
            known = ", ".join(sorted(self._actions)) or "none"
            return f"the robot has no action {call.action[:80]!r}; it has: {known}"
        names = [parameter.name for parameter in action.parameters]
        shown = f"{action.name}({', '.join(names)})"
        given = len(call.arguments) + len(call.keywords)
        if given != len(names):
            return f"{shown} takes {len(names)} argument(s), not {given}"
        bound = dict(zip(names, call.arguments, strict=False))
        for name, value in call.keywords:
            if name not in names:
                return f"{shown} has no parameter {name[:80]!r}"
            if name in bound:
                return f"{shown} is given {name} twice"
            bound[name] = value
        return tuple(bound[name] for name in names)

    def _call_fault(self, call: ActionCall, arguments: tuple[Argument, ...]) -> str | None:
        action = self._actions[call.action]
        for parameter, argument in zip(action.parameters, arguments, strict=True):
            if fault := self._argument_fault(parameter, argument):
                return fault
        objects = [
            argument
            for parameter, argument in zip(action.parameters, arguments, strict=True)
            if parameter.role in ("object", "container")
        ]
        if len(set(objects)) < len(objects):
            return f"{action.name} wants different objects, not {objects[0]!r} twice"
        return None

    def _argument_fault(self, parameter: Parameter, argument: Argument) -> str | None:
        if parameter.role == "number":
            if isinstance(argument, str):
                return f"{parameter.name} is a number, not {argument[:80]!r}"
            return None
        if parameter.role == "word":
            if argument in parameter.words:
                return None
            return f"{parameter.name} is one of {', '.join(map(repr, parameter.words))}"
        if not isinstance(argument, str):
            return f"{parameter.name} is an object's name in quotes, not the number {argument:g}"
        return self._name_fault(argument)

    def _condition_fault(self, condition: Condition) -> str | None:
        if unknown := _property(condition):
            return f"nothing is known of the {unknown[:80]!r} of any object"
        for relation in relations_of(condition):
            if self._relations is not None:
                wanted = self._relations.get(relation.name)
                if wanted is None:
                    known = ", ".join(sorted(self._relations))
                    return f"this world cannot tell {relation.name[:80]!r}; it can: {known}"
                if wanted != len(relation.arguments):
                    given = len(relation.arguments)
                    return f"{relation.name} speaks of {wanted} object(s) here, not {given}"
            for name in relation.arguments:
                if name != self._agent and (fault := self._name_fault(name)):
                    return fault
        return None

    def _name_fault(self, name: str) -> str | None:
        if name in self._names or name in self._single:
            return None
        return f"there is no object {name[:80]!r} in the scene{self._hint(name)}"

    def _hint(self, name: str) -> str:
        if name not in self._hints:
            if len(self._hints) >= MAX_SUGGESTIONS:
                return ""
            likely = nearest(name, sorted(self._names))
            self._hints[name] = f"; did you mean {likely!r}?" if likely else ""
        return self._hints[name]


def _property(condition: Condition) -> str | None:
    """The name of a property that was left undecided, if any."""
    match condition:
        case Property(name, _, _):
            return name
        case Not(inner):
            return _property(inner)
        case AnyOf(conditions):
            return next(filter(None, map(_property, conditions)), None)
        case _:
            return None
