"""Two things that change places: by where they stand, one of them waiting at a free place meanwhile."""

import math
import re
from collections.abc import Iterable

from app.domain.errors import TaskDeclined
from app.domain.planner import Task
from app.domain.program import ActionCall, Comment, Statement
from app.programs.knowledge.names import words
from app.programs.sketches.dialogue import calls_of
from app.programs.sketches.leaving_out import END, POLITE
from app.programs.sketches.naming import Naming
from app.programs.sketches.selection import PRONOUNS, Selection
from app.programs.sketches.things import Thing

_THE = r"(?:the |my |these |those |both )?"
_SWAP = re.compile(
    rf"{POLITE}(?:swap|exchange|switch)(?: the)?(?: places| positions)?(?: of| around| round| between)? "
    rf"{_THE}(?:(?P<one>[\w' -]+?) (?:and|with|for) {_THE}(?P<other>[\w' -]+?)|(?:two )?(?P<both>[\w' -]+?))"
    rf"(?: around| round| over| (?:with )?(?:places|positions))?{END}",
    re.I,
)
REACH = (0.30, 0.62)
"""How near to and how far from the robot a thing may wait [m]."""
_SPOTS = tuple(
    (x / 100, y / 100)
    for x in range(30, 61, 5)
    for y in range(-40, 41, 5)
    if REACH[0] <= math.hypot(x / 100, y / 100) <= REACH[1]
)
APART = 0.03
"""To leave between a thing that waits and the others [m]."""


def swap(task: Task, sentence: str, selection: Selection) -> tuple[Statement, ...] | None:
    """The calls that have two things change places; None where the sentence asks for something else.

    Raises:
        TaskDeclined: no action on offer can do it, or it is not known where they stand.
    """
    match = _SWAP.fullmatch(sentence)
    if match is None or any({"swap", "exchange"} & set(words(a.name)) for a in task.actions):
        return None
    pair = _pair(match, Naming(selection))
    if pair is None and match["both"] in PRONOUNS:
        raise TaskDeclined(
            "nothing tells which two things are meant",
            kind="ambiguous",
            question="Which two things should change places?",
        )
    if pair is None:
        return None
    if not any(action.name == "place_at" for action in task.actions):
        names = ", ".join(action.name for action in task.actions)
        reason = f"no action on offer ({names}) puts a thing where another one stood"
        raise TaskDeclined(reason, kind="impossible")
    one, other = pair
    here, there = _stands(one, task), _stands(other, task)
    free = _free(one, selection.things)
    return (
        Comment(text=f"the {one.name} waits while the {other.name} takes its place"),
        *(
            ActionCall(action="place_at", arguments=(thing.name, *spot))
            for thing, spot in ((one, free), (other, here), (one, there))
        ),
    )


def _pair(match: re.Match[str], naming: Naming) -> tuple[Thing, Thing] | None:
    if match["both"]:
        found = naming.all(match["both"])
        return (found[0], found[1]) if len(found) == 2 else None
    noun = match["other"].split()[-1]
    # "The red and the blue block" are two blocks.
    one = naming.one(match["one"]) or naming.one(f"{match['one']} {noun}")
    other = naming.one(match["other"])
    return (one, other) if one and other and one is not other else None


def _stands(thing: Thing, task: Task) -> tuple[float, float]:
    moved = any(
        thing.name in map(str, call.arguments[:1])
        for turn in task.history
        for call in calls_of(turn.program)
    )
    held = any(fact.name in ("in", "on") and fact.arguments[0] == thing.name for fact in task.facts)
    if moved or held or thing.item.position is None:
        reason = f"where the {thing.name} stands on the table is not known"
        raise TaskDeclined(reason, kind="impossible")
    return round(thing.item.position[0], 3), round(thing.item.position[1], 3)


def _free(thing: Thing, things: Iterable[Thing]) -> tuple[float, float]:
    """The place on the table that is farthest from everything."""

    def room(spot: tuple[float, float]) -> float:
        return min(
            (
                math.dist(spot, each.item.position[:2]) - _radius(each)
                for each in things
                if each.item.position
            ),
            default=1.0,
        )

    best = max(_SPOTS, key=room)
    if room(best) < _radius(thing) + APART:
        raise TaskDeclined(
            f"there is no free place where the {thing.name} could wait", kind="impossible"
        )
    return best


def _radius(thing: Thing) -> float:
    return math.hypot(*thing.item.size[:2]) / 2 if thing.item.size else 0.05
