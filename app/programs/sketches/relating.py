"""Things told by where they stand to another thing: "the cup in front of the jar"."""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from app.programs.knowledge.classes import ThingClass
from app.programs.knowledge.names import words
from app.programs.sketches.description import Description
from app.programs.sketches.matching import find_class
from app.programs.sketches.qualities import AXES, Fits, distance, extreme, is_placed, stands
from app.programs.sketches.things import Thing

_SIDES = {"left_of": "left", "right_of": "right", "in_front_of": "near", "behind": "far"}


def origin(described: Description, other: str, things: Sequence[Thing]) -> ThingClass | None:
    """The class of things that come from there: "everything from the baker's", where no baker is."""
    place = re.sub(r"'s?$", "", " ".join(words(other)))
    if not described.vague or any(place in thing.unmarked for thing in things):
        return None
    return find_class(f"things from the {place}")


_ANYWHERE = Description(text="", core=())


def related(
    kept: Fits, key: str, anchors: Fits, rests: Callable[[str, str], bool], *, many: bool
) -> Fits:
    """Those that stand so to the one thing that the anchors leave no doubt of.

    ``rests`` tells whether one thing, by its name, is in or on another.
    """
    best = max((score for _, score in anchors), default=0.0)
    anchors = [pair for pair in anchors if pair[1] >= best - 0.015]
    if not anchors and key in _SIDES:  # "right of the table": of what everything stands on
        return extreme(kept, replace(_ANYWHERE, side=_SIDES[key]), many)
    if len(anchors) != 1:
        return kept
    anchor = anchors[0][0]
    kept = [pair for pair in kept if pair[0] is not anchor]
    if key in ("inside", "on"):
        return [pair for pair in kept if rests(pair[0].name, anchor.name)] or kept
    here = stands(anchor)
    placed = [(t, s) for t, s in kept if is_placed(t)]
    if not is_placed(anchor) or not placed:
        return kept
    if key == "near":
        return [min(placed, key=lambda pair: distance(pair[0], here))]
    axis, sign = AXES[key]
    beyond = [(t, s) for t, s in placed if sign * (stands(t)[axis] - here[axis]) > 0.005]
    if many or len(beyond) < 2:
        return beyond
    return [min(beyond, key=lambda pair: distance(pair[0], here))]
