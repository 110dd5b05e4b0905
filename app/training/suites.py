"""Instructions with what must come of them: read from a file, for measuring planners strictly."""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation, decide
from app.domain.program import Argument
from app.domain.scene import Position, Scene, SceneObject
from app.programs.conditions import parse_condition
from app.training.executor import PUTS, Outcome
from app.training.words import FOLDER

UNSEEN_VERBS = FOLDER / "unseen-verbs.jsonl"
"""Forty tasks with import lines that the generator never makes."""
ACTION_SETS = {
    "A": ("grab_and_putin(obj1, obj2)",),
    "B": (
        *("grab_and_putin(obj1, obj2)", "put_on(obj1, obj2)", "open(obj)", "close(obj)"),
        *("pour(obj1, obj2)", "push(obj1, obj2)"),
    ),
}
SIDES = {"left": (0.5, 0.2, 0.0), "center": (0.5, 0.0, 0.0), "right": (0.5, -0.2, 0.0)}
_SIGNATURE = re.compile(r"(\w+)\((.*)\)")
_NUMBERS = frozenset({"degrees", "east", "north"})
"""Parameters of the unseen verbs that take numbers."""


class Check(Protocol):
    """Whether the effects are what was wanted, and nothing else was touched."""

    def __call__(self, done: Outcome) -> bool: ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """One instruction in one scene."""

    name: str
    kind: str
    scene: Scene
    sentence: str
    actions: tuple[ActionSignature, ...]
    check: Check
    facts: frozenset[Relation] = frozenset()
    puts: Mapping[str, bool] = field(default_factory=lambda: PUTS)


def read_suite(path: Path) -> list[Item]:
    """One JSON object a line: id, category, actions, objects, instruction, and goal or calls.

    ``actions`` is a name of ``ACTION_SETS`` or a list of signatures; ``goal`` with ``forbidden``
    are conditions on the end, ``calls`` the very calls, in any order where the category is "set".
    """
    return [_item(json.loads(line)) for line in path.read_text(encoding="utf-8").splitlines()]


def signature(text: str) -> ActionSignature:
    """From ``name(parameter, …)``."""
    match = _SIGNATURE.fullmatch(text)
    if match is None:
        raise ValueError(f"an action reads name(obj), not {text!r}")
    names = [each.strip() for each in match[2].split(",") if each.strip()]
    parameters = tuple(
        Parameter(name=each, role="number" if each in _NUMBERS else "object") for each in names
    )
    return ActionSignature(name=match[1], parameters=parameters, meaning="")


def _item(entry: dict[str, Any]) -> Item:
    shown = entry["actions"]
    listed = ACTION_SETS[shown] if isinstance(shown, str) else shown
    exact = "calls" in entry
    return Item(
        name=entry["id"],
        kind=entry["category"],
        scene=Scene(world="tabletop", objects=tuple(_objects(entry["objects"]))),
        sentence=entry["instruction"],
        actions=tuple(map(signature, listed)),
        check=_Calls(entry["calls"], ordered=entry["category"] != "set")
        if exact
        else _Goal(tuple(entry["goal"]), tuple(entry["forbidden"])),
        facts=frozenset(
            Relation(name, (each,))
            for name, objects in entry.get("init", {}).items()
            for each in objects
        ),
        puts={} if exact else PUTS,
    )


def _objects(described: Mapping[str, Mapping[str, Any]]) -> Iterator[SceneObject]:
    for name, told in described.items():
        position = told.get("position")
        yield SceneObject(
            name=name,
            category=told.get("category"),
            colour=told.get("color") or told.get("colour"),
            position=SIDES.get(position) if isinstance(position, str) else _placed(position),
            properties=tuple((key, told[key]) for key in ("material", "size") if key in told),
        )


def _placed(position: Sequence[float] | None) -> Position | None:
    """On the table where no height is told."""
    return None if position is None else (*position, 0.0)[:3]  # pyright: ignore[reportReturnType]


@dataclass(frozen=True, slots=True)
class _Calls:
    calls: list[str]
    ordered: bool = True

    def __call__(self, done: Outcome) -> bool:
        made = [_call(deed) for deed in done.deeds]
        if not self.ordered:
            return sorted(made) == sorted(self.calls) and not done.faults
        return made == self.calls and not done.faults


def _call(deed: tuple[Argument, ...]) -> str:
    return f"{deed[0]}({', '.join(_shown(each) for each in deed[1:])})"


def _shown(value: Argument) -> str:
    return f"{value:g}" if isinstance(value, int | float) else repr(str(value))


@dataclass(frozen=True, slots=True)
class _Goal:
    conditions: tuple[str, ...]
    forbidden: tuple[str, ...]

    def __call__(self, done: Outcome) -> bool:
        def holds(relation: Relation) -> bool:
            return _holds(relation, done)

        changed = {*done.places, *(str(deed[1]) for deed in done.deeds if len(deed) > 1)}
        spoilt = any(each.removeprefix("changed(")[:-1] in changed for each in self.forbidden)
        met = all(decide(parse_condition(each), holds) for each in self.conditions)
        idle = bool(self.conditions) or not (done.places or done.deeds)
        return met and idle and not spoilt and not done.faults


def _holds(relation: Relation, done: Outcome) -> bool:
    name, arguments = relation.name, relation.arguments
    match name:
        case "in" | "on":
            return done.places.get(arguments[0]) == arguments[1]
        case "open" | "closed":
            deeds = [deed[0] for deed in done.deeds if deed[1:] == arguments]
            return deeds[-1:] == ["open" if name == "open" else "close"]
        case _:
            wanted = (name.removesuffix("ed"), *arguments)
            return any(deed[: len(wanted)] == wanted for deed in done.deeds)
