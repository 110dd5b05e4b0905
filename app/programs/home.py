"""Home: the things of one home, and the primitives that an activity comes down to there."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence

from app.domain.condition import Relation
from app.domain.errors import TaskDeclined
from app.domain.program import ActionCall, Assertion, Comment, Statement, Variable
from app.domain.scene import SceneObject
from app.programs.activities import AFFORDED, DROPPED, Activity
from app.programs.home_members import HomeMembers, room_told
from app.programs.home_places import HomePlaces
from app.programs.knowledge.classes import classes
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.hazards import hazard
from app.programs.knowledge.membership import belonging

CLEARLY = 0.7
"""How surely a thing belongs to a class that an activity is not for."""
AT_BEST = ("eat", "drink", "pour", "cut", "wipe")
"""Calls that are left out where they are not on offer."""
FETCHING = ("grab", "put", "open", "close", "find", "walk")
"""Calls of an activity that only brings things somewhere."""
ROOM = "room"
"""The name for the room that the sentence speaks of, if it does."""
PLACE = "place"
"""Name of the parameter for where something is to go, as the sentence tells it."""
STATES: Mapping[str, str] = {
    "open": "open",
    "close": "closed",
    "switchon": "switched_on",
    "switchoff": "switched_off",
}
"""What a call brings about: with feedback it is asserted, and the call is the recovery."""
_MENTIONED = re.compile(r"\{(\w+)\}")


class Home:
    """The things of one home, and the primitives that an activity comes down to there."""

    def __init__(
        self,
        objects: Sequence[SceneObject],
        members: HomeMembers | None = None,
        *,
        feedback: bool,
        sentence: str = "",
        offered: Collection[str] = (),
    ) -> None:
        """``offered`` are the actions on offer; what is only done at best is left out without."""
        self._offered = offered
        self._members = members or HomeMembers(objects)
        self._room = room_told(objects, sentence)
        self._places = HomePlaces(objects, self._members, sentence)
        self._affords = self._places.affords
        self._feedback = feedback
        self._runs: set[str] = set()
        """What was switched on."""
        self._near = ""
        """What was walked up to last."""
        self._onto = ""
        """The place that was told, where it is its surface that is meant: it stays shut."""
        self._sub_tasks = 0

    def suits(self, activity: Activity, arguments: Sequence[str]) -> bool:
        """Whether each of the things affords what the activity does with it."""
        kinds = [self._members.class_of(name) for name in arguments]
        if any(_is(name, each) for name in kinds for each in activity.not_for):
            return False
        return all(
            parameter.affordance is None
            or self._affords[name] & set(parameter.affordance.split("|"))
            for parameter, name in zip(activity.signature.parameters, arguments, strict=True)
        )

    def carry_out(self, activity: Activity, arguments: Sequence[str]) -> Iterator[Statement]:
        """The activity with these things, in primitives.

        Raises:
            TaskDeclined: the home lacks something that it takes, or nothing of it can be done.
        """
        idle = True
        given = self._given(activity, arguments)
        place = given.get(PLACE, "")
        self._onto = place if self._places.is_onto(place) else ""
        for statement in activity.body:
            match statement:
                case Comment(text=text):
                    yield self._comment(text, given)
                case ActionCall() if self._stands_fixed(statement, activity, given):
                    continue
                case ActionCall():
                    names = [self._name(each, given) for each in statement.arguments]
                    if None not in names:
                        for each in self._call(statement.action, [each for each in names if each]):
                            idle = False
                            yield each
                case _:
                    yield statement
        if idle:
            asked = " ".join(
                (activity.signature.name.replace("_", " "), *map(self._members.spoken, arguments))
            )
            raise TaskDeclined(f"nothing here can be done for: {asked}", kind="impossible")

    def needless(self, activity: Activity, arguments: Sequence[str]) -> str | None:
        """What makes it so that nothing is to be done: "the cereal is in the cabinet already"."""
        given = self._given(activity, arguments)
        calls = [each for each in activity.body if isinstance(each, ActionCall)]
        puts = [each for each in calls if each.action == "put"]
        fetching = all(each.action in FETCHING for each in calls)
        if puts and not fetching:
            return None
        brought = puts or [each for each in calls if each.action in STATES]
        if not brought or (not puts and len(brought) < len(calls)):
            return None
        told: list[str] = []
        for call in brought:
            names = [self._name(each, given) for each in call.arguments]
            found = self._so_already(call.action, [each for each in names if each])
            if None not in names and found is None:
                return None
            told += [found] if found else []
        return f"the {' and the '.join(told)} already" if told else None

    def _so_already(self, verb: str, names: Sequence[str]) -> str | None:
        """What the call would bring about, in words, if it is so; None if it is not."""
        state = STATES.get(verb)
        told = [state] if state else ["in", "on"]
        every = self._members.of(names[0]) or (names[0],)
        found = next((each for each in told if self._all(each, every, names[1:])), None)
        if found is None:
            return None
        words_for = " the ".join((found.replace("_", " "), *map(self._members.spoken, names[1:])))
        return f"{self._members.spoken(names[0])} is {words_for}"

    def _all(self, relation: str, things: Sequence[str], others: Sequence[str]) -> bool:
        """Whether it is so of every thing: of one window open somewhere nobody need know."""
        return all(self._members.holds(Relation(relation, (each, *others))) for each in things)

    @staticmethod
    def _given(activity: Activity, arguments: Sequence[str]) -> dict[str, str]:
        names = (each.name for each in activity.signature.parameters)
        return dict(zip(names, arguments, strict=True))

    def _stands_fixed(self, call: ActionCall, activity: Activity, given: Mapping[str, str]) -> bool:
        """Whether it would take what cannot be carried, and is there for something else: a radio."""
        needs = {each.name: each.affordance for each in activity.signature.parameters}
        name = str(call.arguments[-1]) if call.arguments else ""
        taken = call.action == "grab" and needs.get(name, "grabbable") != "grabbable"
        return taken and "grabbable" not in self._affords[given[name]]

    def _comment(self, text: str, given: Mapping[str, str]) -> Comment:
        said = _MENTIONED.sub(
            lambda match: self._members.spoken(given.get(match[1], match[1])), text.strip()
        )
        self._sub_tasks += 1
        return Comment(text=f"{self._sub_tasks - 1}: {said}")

    def done(self) -> Comment:
        """The paper's last comment."""
        return Comment(text=f"{self._sub_tasks}: Done")

    def _name(self, value: object, given: Mapping[str, str]) -> str | None:
        """The thing of the home that is meant; None where it may be missing and is."""
        if isinstance(value, Variable):
            return given[str(value)]
        told = str(value)
        choices = [each.strip() for each in told.removesuffix("?").split("|")]
        if choices == [ROOM]:
            return self._room or None
        found = next((each for each in choices if each in self._affords), None)
        if found and self._room and "grabbable" not in self._affords[found]:
            there = self._members.within(self._members.of(found) or (found,), self._room)
            if not there and told.endswith("?"):
                return None  # The lamp of another room.
            return self._members.one_within(found, self._room)
        if found is None and not told.endswith("?"):
            wanted = " or ".join(map(apart, choices))
            raise TaskDeclined(f"there is no {wanted} here", kind="absent")
        return found

    def _call(self, verb: str, names: Sequence[str]) -> Iterator[Statement]:
        target = names[-1] if names else ""
        if self._left_out(verb, target):
            return
        if verb == "put" and target in self._places.rooms:
            yield ActionCall(action="walk", arguments=(target,))
            self._onto = target = self._places.laid_in(target)
            names = [*names[:-1], target]
        if target and target != self._near and verb not in ("find", "walk"):
            yield ActionCall(action="find", arguments=(target,))
            yield from self._asserted(Relation("near", (target,)), ("find", target))
        self._near = target
        if verb in ("put", "pour"):
            self._refuse_harm(names[0], target)
        self._runs |= {self._members.class_of(target)} if verb == "switchon" else set()
        if verb == "put":
            verb = "putback" if target == self._onto else self._places.verb(target)
            yield from self._asserted(
                Relation("held", (names[0],)), ("find", names[0]), ("grab", names[0])
            )
        call = ActionCall(action=verb, arguments=tuple(names))
        state = STATES.get(verb)
        if self._feedback and state:
            yield Assertion(condition=Relation(state, (target,)), recovery=(call,))
        else:
            yield call

    def _left_out(self, verb: str, target: str) -> bool:
        if verb in DROPPED and not self._affords[target] & set(AFFORDED[verb].split("|")):
            return True
        shut = verb in ("open", "close") and target == self._onto
        return shut or (verb in AT_BEST and verb not in self._offered)

    def _asserted(self, condition: Relation, *recovery: tuple[str, str]) -> Iterator[Assertion]:
        if self._feedback:
            calls = tuple(ActionCall(action=verb, arguments=(name,)) for verb, name in recovery)
            yield Assertion(condition=condition, recovery=calls)

    def _refuse_harm(self, name: str, place: str) -> None:
        """Raises TaskDeclined: it can hurt somebody or ruin the thing."""
        thing, where = (apart(self._members.class_of(each)) for each in (name, place))
        full = "full sink" if where.endswith("sink") and "faucet" in self._runs else where
        if rule := hazard(thing, full):
            raise TaskDeclined(
                f"the {thing} in, on or at the {where}: {rule.reason}",
                kind="hazardous",
                question=f"Where else should the {thing} go?",
            )


def _is(name: str, other: str) -> bool:
    """Whether the thing is the other one, or of its class."""
    kind = classes().find(other)
    return name == other or bool(kind and belonging(apart(name), kind) >= CLEARLY)
