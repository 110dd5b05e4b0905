from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.displacement import lifted
from app.worlds.actions.preconditions import require_free_gripper
from app.worlds.actions.tabletop import actions
from app.worlds.actions.taking import Taking
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("pick")
class PickUp:
    """Takes an object into the gripper and keeps it there, the arm at home."""

    signature = ActionSignature(
        name="pick",
        parameters=(Parameter(name="obj"),),
        meaning="Take obj into the gripper and hold it, for a verb that places it.",
        said=r"\b(?:pick up|lift|hold)\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """The object is held, with what it carries.

        Raises:
            ActionFailure: the gripper holds something else.
        """
        (item,) = arguments
        require_free_gripper(facts, item)
        return Effects() if Relation("held", (item,)) in facts else lifted(facts, item)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        (item,) = arguments
        require_free_gripper(cell.relations.facts(), item)
        if not cell.relations.holds(Relation("held", (item,))):
            yield from Taking(cell, rng, item).take_home()
