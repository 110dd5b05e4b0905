"""Activities: what people ask for at home, each a function of the plan language in a file of its own.

    def heat(food):
        # warm the {food}
        put(food, 'microwave | oven')

A name with ``|`` is the first of these that the home has; one with ``?`` may be missing. ``put`` is
``putin`` or ``putback``, as its place affords. Walking up to things is left out of the files.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation
from app.domain.errors import TaskDeclined
from app.domain.program import ActionCall, Assertion, Comment, Statement, Variable
from app.domain.scene import SceneObject
from app.programs.examples import FOLDER
from app.programs.home_members import HomeMembers, room_told
from app.programs.knowledge.classes import belonging, classes
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.names import words
from app.programs.parser import parse_program

CLEARLY = 0.7
"""How surely a thing belongs to a class that an activity is not for."""
AFFORDED: Mapping[str, str] = {
    "grab": "grabbable",
    "put": "containers|surfaces",
    "open": "can_open",
    "close": "can_open",
    "switchon": "has_switch",
    "switchoff": "has_switch",
    "sit": "sittable|lieable",
}
"""What a call takes its last thing to afford."""
DROPPED = ("open", "close", "switchon", "switchoff", "sit")
"""Calls that are left out where the thing does not afford them."""
RUN = ("machine", "computer")
"""Names of parameters for what is switched on."""
ROOM = "room"
"""The name for the room that the sentence speaks of, if it does."""
PLACE = "place"
"""Name of the parameter for where something is to go, as the sentence tells it."""
INTO = frozenset(("in", "into", "inside"))
ONTO = frozenset(("to", "on", "onto", "upon", "at", "by"))
STATES: Mapping[str, str] = {
    "open": "open",
    "close": "closed",
    "switchon": "switched_on",
    "switchoff": "switched_off",
}
"""What a call brings about: with feedback it is asserted, and the call is the recovery."""
_HEAD = re.compile(r"^def (\w+)\((.*)\):$", re.M)
_MENTIONED = re.compile(r"\{(\w+)\}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Activity:
    """One function."""

    signature: ActionSignature
    body: tuple[Statement, ...]
    said_with: frozenset[str] = frozenset()
    """Words or phrases of which one stands in every sentence that asks for it; none for any."""
    not_said_with: frozenset[str] = frozenset()
    """Words or phrases of which none stands there."""
    not_for: frozenset[str] = frozenset()
    """Things, and classes of things, that nobody does it with."""

    def may_be_meant(self, sentence: str) -> bool:
        """Whether the sentence can ask for it, by its words."""
        said = f" {' '.join(words(sentence))} "
        if any(f" {each} " in said for each in self.not_said_with):
            return False
        return not self.said_with or any(f" {each} " in said for each in self.said_with)


@cache
def load_activities(world: str) -> tuple[Activity, ...]:
    """The world's activities in the order of their names; none where it has no folder."""
    return tuple(
        _activity(file.read_text(encoding="utf-8"))
        for file in sorted((FOLDER / world / "activities").glob("*.py"))
    )


def _activity(text: str) -> Activity:
    head = _HEAD.search(text)
    if head is None:
        raise ValueError(f"an activity begins with def, not {text[:40]!r}")
    name, parameters = head.groups()
    called = ", ".join(f"'{each}'" for each in parameters.split(", ") if each)
    helper = parse_program(f"{text}\n\ndef task():\n    {name}({called})\n").helpers[0]
    told = text.split('"""')[1].strip() if text.startswith('"""') else ""
    meaning = told.partition("\n\n")[0]
    taken = tuple(
        Parameter(name=each, affordance=_needed(each, helper.body)) for each in helper.parameters
    )
    signature = ActionSignature(name=helper.name, parameters=taken, meaning=meaning)
    return Activity(
        signature=signature,
        body=helper.body,
        said_with=_listed(told, "Said with: "),
        not_said_with=_listed(told, "Not said with: "),
        not_for=_listed(told, "Not for: "),
    )


def _listed(told: str, label: str) -> frozenset[str]:
    """What a line of the docstring lists after its label."""
    line = next((each for each in told.splitlines() if each.startswith(label)), label)
    listed = line.removeprefix(label).rstrip(".").split(",")
    return frozenset(each.strip() for each in listed if each.strip())


def _needed(parameter: str, body: Sequence[Statement]) -> str | None:
    """What the calls on the parameter take it to afford, those first that cannot be left out."""
    verbs = [
        call.action
        for call in body
        if isinstance(call, ActionCall) and call.arguments and parameter == str(call.arguments[-1])
    ]
    if parameter in RUN:
        return "has_switch"
    verbs.sort(key=lambda verb: verb in DROPPED)
    return next((AFFORDED[verb] for verb in verbs if verb in AFFORDED), None)


class Home:
    """The things of one home, and the primitives that an activity comes down to there."""

    def __init__(
        self,
        objects: Sequence[SceneObject],
        members: HomeMembers | None = None,
        *,
        feedback: bool,
        sentence: str = "",
    ) -> None:
        self._members = members or HomeMembers(objects)
        self._room = room_told(objects, sentence)
        self._sentence = f" {' '.join(words(sentence))} "
        self._affords = {
            name: frozenset(dict(item.properties).get("affordances", "").split())
            for item in objects
            for name in (item.name, *item.members())
        }
        self._feedback = feedback
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
        given = dict(
            zip((each.name for each in activity.signature.parameters), arguments, strict=True)
        )
        place = given.get(PLACE, "")
        self._onto = place if self._is_onto(place) else ""
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
        if found and self._room:
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
        if verb in DROPPED and not self._affords[target] & set(AFFORDED[verb].split("|")):
            return
        if verb in ("open", "close") and target == self._onto:
            return
        if target and target != self._near and verb not in ("find", "walk"):
            yield ActionCall(action="find", arguments=(target,))
            yield from self._asserted(Relation("near", (target,)), ("find", target))
        self._near = target
        if verb == "put":
            verb = self._put(target)
            yield from self._asserted(
                Relation("held", (names[0],)), ("find", names[0]), ("grab", names[0])
            )
        call = ActionCall(action=verb, arguments=tuple(names))
        state = STATES.get(verb)
        if self._feedback and state:
            yield Assertion(condition=Relation(state, (target,)), recovery=(call,))
        else:
            yield call

    def _asserted(self, condition: Relation, *recovery: tuple[str, str]) -> Iterator[Assertion]:
        if self._feedback:
            calls = tuple(ActionCall(action=verb, arguments=(name,)) for verb, name in recovery)
            yield Assertion(condition=condition, recovery=calls)

    def _is_onto(self, place: str) -> bool:
        """Whether "to the nightstand" is onto it: what has a surface is opened for "into" alone."""
        if not {"can_open", "surfaces"} <= self._affords.get(place, frozenset()):
            return False
        said = set(self._sentence.split())
        if said & ONTO and said & INTO:
            inside = "|".join(sorted(INTO))
            return not re.search(rf" (?:{inside}) (?:\w+ )?{apart(place)} ", self._sentence)
        return not said & INTO

    def _put(self, place: str) -> str:
        if place == self._onto:
            return "putback"
        affords = self._affords[place]
        inside = "can_open" in affords or "surfaces" not in affords
        return "putin" if inside and affords & {"containers", "can_open"} else "putback"


def _is(name: str, other: str) -> bool:
    """Whether the thing is the other one, or of its class."""
    kind = classes().find(other)
    return name == other or bool(kind and belonging(apart(name), kind) >= CLEARLY)
