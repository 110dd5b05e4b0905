from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.operating import Operating
from app.worlds.actions.preconditions import require_free_gripper, require_shutting
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("close")
class Close:
    """Closes a drawer, a door or a lid by its handle."""

    signature = ActionSignature(
        name="close",
        parameters=(Parameter(name="obj"),),
        meaning="Close obj, which has a drawer, a door or a lid.",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It is closed.

        Raises:
            ActionFailure: it is nothing that opens and closes, or the gripper holds something.
        """
        (item,) = arguments
        require_shutting(Relation("shuts", (item,)) in facts, item)
        require_free_gripper(facts)
        return Effects(
            adds=frozenset({Relation("closed", (item,))}),
            removes=frozenset({Relation("open", (item,))}),
        )

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        (item,) = arguments
        require_shutting(cell.physics.bodies[item].articulation is not None, item)
        require_free_gripper(cell.relations.facts())
        if not cell.relations.holds(Relation("closed", (item,))):
            yield from Operating(cell, rng, item, "closed").run()
