"""Pouring out: take a vessel, tilt it over another, tilt it back, put it where it stood, check."""

from collections.abc import Iterator

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.borrowing import Borrowing
from app.worlds.actions.manoeuvre import CARRY_SPEED
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.pouring import Poured, Pouring

TILTING = 0.35
"""Fraction of the joints' limits while the contents move."""
EMPTYING = 1.0
"""How long it stays tilted [s]."""


class PouringOut(Borrowing[Poured]):
    """Empties one vessel into another. ``run`` carries it out."""

    def _way(self, goal: Cloud) -> Poured:
        """How to empty what is held over the middle of the target's mouth."""
        over = np.append((goal.lowest + goal.highest)[:2] / 2, goal.highest[2])
        cell = self._cell
        return Pouring(cell.physics, cell.collisions, self._rng).choose(self._item, over)

    def _use(self, way: Poured) -> Iterator[Stage]:
        """Go there, tilt, and come back to where it began."""
        manipulator = self._cell.manipulator
        yield from self._during("carry", manipulator.follow(way.carry, CARRY_SPEED))
        yield from self._during("pour", manipulator.trace(way.tilt, TILTING))
        yield from self._during("pour", manipulator.wait(EMPTYING))
        yield from self._during("pour", manipulator.trace(way.tilt[::-1], CARRY_SPEED))
        if not self._held():
            raise ActionFailure("pour", f"slipped: {self._item} was lost while it was tilted")
        yield from self._during("carry", manipulator.follow(way.carry[::-1], CARRY_SPEED))

    def _check_done(self) -> None:
        if not self._cell.relations.holds(Relation("poured", (self._item, self._target))):
            raise ActionFailure(
                "check", f"too little of what was in {self._item} is in {self._target}"
            )

    def _check_returned(self) -> None:
        if not self._cell.relations.holds(Relation("upright", (self._item,))):
            raise ActionFailure("check", f"{self._item} does not stand upright")
