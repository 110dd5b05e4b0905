"""Operating: look, take a drawer, a door or a lid by its fin, move it, let go, check."""

from collections.abc import Iterator

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import CLOSE_SPEED, FREE_SPEED, LIFT_SPEED, Manoeuvre
from app.worlds.simulators.mujoco.handle import WIDE, Handle
from app.worlds.simulators.mujoco.workcell import Workcell

ATTEMPTS = 3
HAUL_SPEED = 0.35
"""A fraction of the joints' limits."""
SQUEEZE = 0.004
"""The fingers are told to close so much farther than the fin is thick, each [m]: gently, so that a
lid's fin can turn between them."""
GOALS = {"open": 0.97, "closed": 0.0}
"""Shares of the travel."""


class Operating(Manoeuvre):
    """Opens or closes one object. ``run`` carries it out."""

    _item: str

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str, wanted: str) -> None:
        """Describe it; ``wanted`` is ``open`` or ``closed``."""
        super().__init__(cell, rng, item)
        self._wanted = Relation(wanted, (item,))

    def run(self) -> Iterator[Stage]:
        """Move the part, in up to ``ATTEMPTS`` attempts.

        Raises:
            ActionFailure: it did not succeed; the arm is at home.
        """
        yield from self.come_home()
        for self._attempt in range(1, ATTEMPTS + 1):
            yield self._stage("look")
            yield from self._haul()
            yield from self.come_home()
            yield from self._come_to_rest()
            if self._cell.relations.holds(self._wanted):
                return
        raise ActionFailure("check", f"{self._item} is not {self._wanted.name}")

    def _haul(self) -> Iterator[Stage]:
        cell, manipulator = self._cell, self._cell.manipulator
        self._look_at(self._item)
        cell.collisions.refresh()
        handle = Handle(cell.physics, cell.physics.bodies[self._item])
        haul = handle.haul(cell.collisions, GOALS[self._wanted.name], self._rng)
        articulation = cell.physics.bodies[self._item].articulation
        assert articulation is not None
        yield from self._during("reach", manipulator.follow(haul.reach, FREE_SPEED))
        yield from self._during("reach", manipulator.open(WIDE, 0.15))
        yield from self._during("approach", manipulator.trace(haul.lower, CLOSE_SPEED))
        squeezed = articulation.thickness / 2 - SQUEEZE
        yield from self._during("grasp", manipulator.grip(squeezed, 0.35, 0.2))
        yield from self._during("haul", manipulator.trace(haul.along, HAUL_SPEED))
        yield from self._during("haul", manipulator.wait(0.1))
        yield from self._during("release", manipulator.grip(WIDE, 0.25))
        yield from self._during("retreat", manipulator.trace(haul.rise, LIFT_SPEED))
        self._look_at(self._item)  # The way home leads past a lid that stands up now.
