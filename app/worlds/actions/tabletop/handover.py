from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.aims import Across
from app.worlds.actions.displacement import moved_beside
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.preconditions import require_free_gripper
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("handover")
class HandOver:
    """Brings an object to the person across the table, and lets go of it there."""

    signature = ActionSignature(
        name="handover",
        parameters=(Parameter(name="obj"),),
        meaning="Hand obj over: put it down in front of the person across the table.",
        said=r"\b(?:hand|pass|give|bring|fetch|get|reach)\b.*\b(?:me|us|him|her)\b|\bhand .*over\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands on the far strip of the table, within the person's reach.

        Raises:
            ActionFailure: the gripper holds something else.
        """
        (item,) = arguments
        require_free_gripper(facts, item)
        done = Relation("handed_over", (item,))
        if done in facts:
            return Effects()
        moved = moved_beside(facts, item, Across.WISH)
        return Effects(adds=moved.adds | {done}, removes=moved.removes - {done})

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        (item,) = arguments
        require_free_gripper(cell.relations.facts(), item)
        aim = Across(cell, item)
        if not aim.reached():
            yield from PickAndPlace(cell, rng, item, aim).run()
