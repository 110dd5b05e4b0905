from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.displacement import moved_beside, place_of
from app.worlds.actions.preconditions import require_free_gripper, require_reach
from app.worlds.actions.shoving import Shoving
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell

DISTANCE = 0.10
"""How far an object is pushed [m]."""
DIRECTIONS = {
    "left": np.array([0.0, 1.0]),
    "right": np.array([0.0, -1.0]),
    "forward": np.array([1.0, 0.0]),
    "back": np.array([-1.0, 0.0]),
}
"""As the robot sees it: x ahead of it, y to its left."""


@actions.register("push")
class Push:
    """Shoves an object over the table."""

    signature = ActionSignature(
        name="push",
        parameters=(
            Parameter(name="obj"),
            Parameter(name="direction", role="word", words=tuple(DIRECTIONS)),
        ),
        meaning="Push obj about 10 cm over the table, to the left, right, forward or back.",
        said=r"\b(?:push|shove|nudge|slide)\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands farther on in that direction, with what is in or on it.

        Raises:
            ActionFailure: it stands in or on something or would leave the reach of the arm, or the
                gripper holds something.
        """
        item, direction = arguments
        place = np.array(place_of(facts, item)) + DISTANCE * _towards(direction)
        _refuse(facts, item, place)
        return moved_beside(facts, item, (float(place[0]), float(place[1])))

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, direction = arguments
        towards = _towards(direction)
        place = cell.relations.place(item) + DISTANCE * towards
        _refuse(cell.relations.facts(), item, place)
        yield from Shoving(cell, rng, item, towards, DISTANCE).run()


def _towards(direction: str) -> np.ndarray:
    if direction not in DIRECTIONS:
        known = ", ".join(DIRECTIONS)
        raise ActionFailure("check", f"there is no direction {direction[:40]!r}; there is {known}")
    return DIRECTIONS[direction]


def _refuse(facts: frozenset[Relation], item: str, place: np.ndarray) -> None:
    require_free_gripper(facts)
    for fact in facts:
        if fact.name in ("in", "on") and fact.arguments[0] == item:
            raise ActionFailure("check", f"{item} is {fact.name} {fact.arguments[1]}")
    require_reach(float(place[0]), float(place[1]))
