"""Program + scene → ``Plan``: what names something that is not there becomes a rejected call."""

from collections.abc import Iterable, Mapping

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import relations as relations_of
from app.domain.plan import Call, GroundedAssertion, GroundedCall, Plan, RejectedCall, Step
from app.domain.program import ActionCall, Argument, Assertion, Comment, Pass, Program
from app.domain.scene import Scene
from app.programs.conditions import nearest, print_condition

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
    """
    grounding = _Grounding(scene, actions, relations)
    steps: list[Step] = []
    comment: str | None = None
    for statement in program.body:
        match statement:
            case Comment(text=text):
                comment = text
                steps.append(statement)
            case ActionCall():
                steps.append(grounding.call(statement, comment))
            case Assertion():
                steps.append(grounding.assertion(statement, comment))
            case Pass():
                pass
    return Plan(steps=tuple(steps))


class _Grounding:
    """What a program may name."""

    def __init__(
        self,
        scene: Scene,
        actions: Iterable[ActionSignature],
        relations: Mapping[str, int] | None,
    ) -> None:
        self._names = frozenset(scene.names)
        self._actions = {action.name: action for action in actions}
        self._relations = relations
        self._hints: dict[str, str] = {}

    def call(self, call: ActionCall, comment: str | None) -> Call:
        reason = self._call_fault(call)
        if reason:
            return RejectedCall(line=call.line, text=str(call), reason=reason)
        return GroundedCall(
            line=call.line, action=call.action, arguments=call.arguments, comment=comment
        )

    def assertion(self, assertion: Assertion, comment: str | None) -> Step:
        reason = self._condition_fault(assertion)
        if reason:
            text = f"assert {print_condition(assertion.condition)}"
            return RejectedCall(line=assertion.line, text=text, reason=reason)
        recovery = tuple(self.call(call, comment) for call in assertion.recovery)
        return GroundedAssertion(
            line=assertion.line, condition=assertion.condition, recovery=recovery
        )

    def _call_fault(self, call: ActionCall) -> str | None:
        action = self._actions.get(call.action)
        if action is None:
            known = ", ".join(sorted(self._actions)) or "none"
            return f"the robot has no action {call.action[:80]!r}; it has: {known}"
        wanted, given = len(action.parameters), len(call.arguments)
        if wanted != given:
            names = ", ".join(parameter.name for parameter in action.parameters)
            return f"{action.name}({names}) takes {wanted} argument(s), not {given}"
        for parameter, argument in zip(action.parameters, call.arguments, strict=True):
            if fault := self._argument_fault(parameter, argument):
                return fault
        objects = [argument for argument in call.arguments if isinstance(argument, str)]
        if len(set(objects)) < len(objects):
            return f"{action.name} wants different objects, not {objects[0]!r} twice"
        return None

    def _argument_fault(self, parameter: Parameter, argument: Argument) -> str | None:
        if parameter.role == "number":
            if isinstance(argument, str):
                return f"{parameter.name} is a number, not {argument[:80]!r}"
            return None
        if not isinstance(argument, str):
            return f"{parameter.name} is an object's name in quotes, not the number {argument:g}"
        return self._name_fault(argument)

    def _condition_fault(self, assertion: Assertion) -> str | None:
        for relation in relations_of(assertion.condition):
            if self._relations is not None:
                wanted = self._relations.get(relation.name)
                if wanted is None:
                    known = ", ".join(sorted(self._relations))
                    return f"this world cannot tell {relation.name[:80]!r}; it can: {known}"
                if wanted != len(relation.arguments):
                    given = len(relation.arguments)
                    return f"{relation.name} speaks of {wanted} object(s) here, not {given}"
            for name in relation.arguments:
                if fault := self._name_fault(name):
                    return fault
        return None

    def _name_fault(self, name: str) -> str | None:
        if name in self._names:
            return None
        return f"there is no object {name[:80]!r} in the scene{self._hint(name)}"

    def _hint(self, name: str) -> str:
        if name not in self._hints:
            if len(self._hints) >= MAX_SUGGESTIONS:
                return ""
            likely = nearest(name, sorted(self._names))
            self._hints[name] = f"; did you mean {likely!r}?" if likely else ""
        return self._hints[name]
