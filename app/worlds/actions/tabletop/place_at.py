from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.aims import At
from app.worlds.actions.displacement import moved_beside
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.preconditions import require_free_gripper, require_reach
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("place_at")
class PlaceAt:
    """Puts an object on the table at a place."""

    signature = ActionSignature(
        name="place_at",
        parameters=(
            Parameter(name="obj"),
            Parameter(name="x", role="number"),
            Parameter(name="y", role="number"),
        ),
        meaning="Put obj on the table x metres ahead of the robot and y metres to its left.",
        said=r"\b(?:swap|exchange|switch|back|off|out|undo|rückgängig)\b|\d",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands there, and in or on nothing.

        Raises:
            ActionFailure: the place is out of reach, or the gripper holds something else.
        """
        item, x, y = arguments[0], float(arguments[1]), float(arguments[2])
        require_reach(x, y)
        require_free_gripper(facts, item)
        return moved_beside(facts, item, (x, y))

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, x, y = arguments[0], float(arguments[1]), float(arguments[2])
        require_reach(x, y)
        require_free_gripper(cell.relations.facts(), item)
        aim = At(cell, item, np.array([x, y]))
        if not aim.reached():
            yield from PickAndPlace(cell, rng, item, aim).run()
