from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.displacement import moved_beside, place_of
from app.worlds.actions.preconditions import require_free_gripper
from app.worlds.actions.righting_up import RightingUp
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("upright")
class Upright:
    """Puts an object that fell over on its foot again."""

    signature = ActionSignature(
        name="upright",
        parameters=(Parameter(name="obj"),),
        meaning="Put obj, which lies on its side, upright on the table.",
        said=r"\bupright\b|\bstand .+ up\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands upright on the table.

        Raises:
            ActionFailure: the gripper holds something.
        """
        (item,) = arguments
        require_free_gripper(facts)
        stands = Relation("upright", (item,))
        if stands in facts:
            return Effects()
        moved = moved_beside(facts, item, place_of(facts, item))
        return Effects(adds=moved.adds | {stands}, removes=moved.removes)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        (item,) = arguments
        require_free_gripper(cell.relations.facts())
        if not cell.relations.holds(Relation("upright", (item,))):
            yield from RightingUp(cell, rng, item).run()
