"""Activities: what people ask for at home, each a function of the plan language in a file of its own.

    def heat(food):
        # warm the {food}
        put(food, 'microwave | oven')

A name with ``|`` is the first of these that the home has; one with ``?`` may be missing. ``put`` is
``putin`` or ``putback``, as its place affords. Walking up to things is left out of the files.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from app.domain.action import ActionSignature, Parameter
from app.domain.program import ActionCall, Statement
from app.programs.examples import FOLDER
from app.programs.knowledge.names import words
from app.programs.parser import parse_program

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
_HEAD = re.compile(r"^def (\w+)\((.*)\):$", re.M)


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
    needs: frozenset[str] = frozenset()
    """Actions without which nothing of it would be done."""

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
        needs=_listed(told, "Needs: "),
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
