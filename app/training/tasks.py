"""A task and its answer: what is asked, the steps that do it, and where everything then is."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from app.training.phrases import Speaker
from app.training.scenes import Item, Setting

Step = tuple[str, ...]
"""``("#", text)`` is a comment; else an action's name with its arguments; ``("pass",)`` declines."""
PUT = "put"


@dataclass(frozen=True, slots=True)
class Answered:
    """An instruction with the steps of its program."""

    sentence: str
    steps: tuple[Step, ...]
    goal: dict[str, str]
    """Where each object that is to be moved ends up; nothing else may move."""


Maker = Callable[[Speaker, Setting], Answered | None]
"""Asks something of a scene, or finds that the scene has nothing of the sort to ask."""
F = TypeVar("F", bound=Maker)

MAKERS: dict[str, Maker] = {}
"""Every kind of task by name."""
WEIGHTS = {
    "simple": 5,
    "two goals": 4,
    "several places": 4,
    "one in each": 5,
    "pronoun": 3.5,
    "by use": 25,
    "by class": 5,
    "by property": 8,
    "other word": 12,
    "left and right": 60,
    "side of a place": 12,
    "stacking": 7,
    "sort class": 22,
    "class and rest": 7,
    "sort property": 20,
    "same colour": 12,
    "except": 9,
    "counting": 7,
    "absent": 5,
    "absent kind": 4,
    "too few": 1.6,
    "no such skill": 1.5,
    "into itself": 0.7,
    "ambiguous": 3,
}
"""How readily each kind is asked for; the rarer a scene is fit for it, the more."""


def task_kind(name: str) -> Callable[[F], F]:
    """Register a maker of tasks."""

    def add(maker: F) -> F:
        MAKERS[name] = maker
        return maker

    return add


def put(items: Sequence[Item], holder: Item) -> list[Step]:
    """One call for each of them."""
    return [(PUT, item.name, holder.name) for item in items]


def stated(what: str, items: Sequence[Item]) -> Step:
    """The comment that says which objects are meant."""
    return ("#", f"{what}: {', '.join(item.name for item in items)}")


def answer(sentence: str, steps: Sequence[Step]) -> Answered:
    """The steps' own effects are the goal: the last place each object was put."""
    goal = {step[1]: step[2] for step in steps if step[0] == PUT}
    return Answered(sentence, tuple(steps), goal)


def declined(sentence: str, reason: str) -> Answered:
    """Nothing is done, and the comment says why."""
    return Answered(sentence, (("#", reason), ("pass",)), {})
