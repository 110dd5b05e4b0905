"""Instructions with their goals: held out of the generator's own words, or read from a file."""

import itertools
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation, decide
from app.programs.conditions import parse_condition
from app.training.executor import PUTS, Outcome, outcome
from app.training.generator import Example, Part, generate

SEED = 7
"""Of the held-out suite, so that everybody measures on the same one."""


def _signature(name: str, *parameters: str) -> ActionSignature:
    shown = tuple(Parameter(name=each) for each in parameters)
    return ActionSignature(name=name, parameters=shown, meaning="")


GRAB_AND_PUTIN = _signature("grab_and_putin", "obj1", "obj2")
ACTION_SETS = {
    "A": (GRAB_AND_PUTIN,),
    "B": (
        GRAB_AND_PUTIN,
        _signature("put_on", "obj1", "obj2"),
        _signature("open", "obj"),
        _signature("close", "obj"),
        _signature("pour", "obj1", "obj2"),
        _signature("push", "obj1", "obj2"),
    ),
}


class Check(Protocol):
    """Whether the effects are what was wanted, and nothing else was touched."""

    def __call__(self, done: Outcome) -> bool: ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """One instruction in one scene."""

    name: str
    kind: str
    objects: Mapping[str, Mapping[str, str]]
    """Properties as words, by the object's name."""
    sentence: str
    actions: tuple[ActionSignature, ...]
    puts: Mapping[str, bool]
    check: Check


def held_out(per_kind: int, seed: int = SEED) -> list[Item]:
    """As many of each kind of task, from nouns, classes and phrasings kept out of training."""
    found: dict[str, list[Item]] = {}
    for number, example in enumerate(itertools.islice(generate(seed, "held"), 60 * per_kind)):
        for part in example.parts:
            items = found.setdefault(part.kind, [])
            if len(items) < per_kind:
                items.append(_held_item(f"{part.kind} {number}", example, part))
    return [item for kind in sorted(found) for item in found[kind]]


def read_suite(path: Path) -> list[Item]:
    """One JSON object a line: id, category, actions, objects, instruction, goal, forbidden."""
    return list(_read(path))


def _read(path: Path) -> Iterator[Item]:
    for line in path.read_text(encoding="utf-8").splitlines():
        entry = json.loads(line)
        yield Item(
            name=entry["id"],
            kind=entry["category"],
            objects=entry["objects"],
            sentence=entry["instruction"],
            actions=ACTION_SETS[entry["actions"]],
            puts=PUTS,
            check=_Goal(tuple(entry["goal"]), tuple(entry["forbidden"])),
        )


def _held_item(name: str, example: Example, part: Part) -> Item:
    puts = {example.verbs.put: example.verbs.swapped}
    return Item(
        name=name,
        kind=part.kind,
        objects=example.objects,
        sentence=part.sentence,
        actions=example.verbs.signatures,
        puts=puts,
        check=_Same(outcome(part.target, example.names, puts)),
    )


@dataclass(frozen=True, slots=True)
class _Same:
    wanted: Outcome

    def __call__(self, done: Outcome) -> bool:
        return done == self.wanted


@dataclass(frozen=True, slots=True)
class _Goal:
    conditions: tuple[str, ...]
    forbidden: tuple[str, ...]

    def __call__(self, done: Outcome) -> bool:
        def holds(relation: Relation) -> bool:
            return _holds(relation, done)

        changed = {*done.places, *(deed[1] for deed in done.deeds if len(deed) > 1)}
        spoilt = any(each.removeprefix("changed(")[:-1] in changed for each in self.forbidden)
        met = all(decide(parse_condition(each), holds) for each in self.conditions)
        return met and not spoilt and not done.faults


def _holds(relation: Relation, done: Outcome) -> bool:
    name, arguments = relation.name, relation.arguments
    match name:
        case "in" | "on":
            return done.places.get(arguments[0]) == arguments[1]
        case "open" | "closed":
            deeds = [deed[0] for deed in done.deeds if deed[1:] == arguments]
            return deeds[-1:] == ["open" if name == "open" else "close"]
        case _:
            return (name.removesuffix("ed"), *arguments) in done.deeds
