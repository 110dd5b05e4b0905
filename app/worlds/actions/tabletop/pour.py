from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.pouring_out import PouringOut
from app.worlds.actions.preconditions import refuse_circle, refuse_itself, require_free_gripper
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("pour")
class Pour:
    """Pours what is in one vessel into another, and puts it back unless it was held before."""

    signature = ActionSignature(
        name="pour",
        parameters=(Parameter(name="source"), Parameter(name="target", role="container")),
        meaning="Pour what is in source into target, and put source back.",
        said=r"\b(?:pour|empty|fill)\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """The contents are in the target; both are where they were, be it in the gripper.

        Raises:
            ActionFailure: it cannot be poured there, or the gripper holds something else.
        """
        source, target = arguments
        refuse_itself(source, target, "poured into")
        refuse_circle(facts, source, target)
        require_free_gripper(facts, source)
        for name in (source, target):
            if Relation("container", (name,)) not in facts:
                raise ActionFailure("check", f"{name} is no container")
        return Effects(adds=frozenset({Relation("poured", (source, target))}))

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        source, target = arguments
        facts = cell.relations.facts()
        refuse_itself(source, target, "poured into")
        refuse_circle(facts, source, target)
        require_free_gripper(facts, source)
        for name in (source, target):
            if cell.physics.bodies[name].opening is None:
                raise ActionFailure("check", f"{name} is no container")
        if source not in cell.physics.beads:
            raise ActionFailure("check", f"{source}: there is nothing in it to pour")
        if not cell.relations.holds(Relation("poured", (source, target))):
            yield from PouringOut(cell, rng, source, target).run()
