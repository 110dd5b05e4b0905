"""Shutting: what opening and closing have in common; the one undoes the other."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from app.domain.action import ActionSignature, Effects
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.operating import Operating
from app.worlds.actions.preconditions import require_free_gripper, require_shutting
from app.worlds.simulators.mujoco.workcell import Workcell


class Shutting:
    """Moves a drawer, a door or a lid by its handle until it is as wanted."""

    signature: ActionSignature
    wanted: ClassVar[str]
    """The relation that holds afterwards: ``open`` or ``closed``."""
    undone: ClassVar[str]
    """The one that no longer does."""

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It is as wanted.

        Raises:
            ActionFailure: it is nothing that opens and closes, or the gripper holds something.
        """
        (item,) = arguments
        require_shutting(Relation("shuts", (item,)) in facts, item)
        require_free_gripper(facts)
        return Effects(
            adds=frozenset({Relation(self.wanted, (item,))}),
            removes=frozenset({Relation(self.undone, (item,))}),
        )

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        (item,) = arguments
        require_shutting(cell.physics.bodies[item].articulation is not None, item)
        require_free_gripper(cell.relations.facts())
        if not cell.relations.holds(Relation(self.wanted, (item,))):
            yield from Operating(cell, rng, item, self.wanted).run()
