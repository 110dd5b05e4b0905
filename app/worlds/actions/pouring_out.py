"""Pouring out: take a vessel, tilt it over another, tilt it back, put it where it stood, check."""

from collections.abc import Iterator

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import CARRY_SPEED, FREE_SPEED, LIFT_SPEED
from app.worlds.actions.taking import ATTEMPTS, Taking
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.picking import Pick
from app.worlds.simulators.mujoco.pouring import Poured, Pouring
from app.worlds.simulators.mujoco.workcell import Workcell

TILTING = 0.35
"""Fraction of the joints' limits while the contents move."""
EMPTYING = 1.0
"""How long it stays tilted [s]."""


class PouringOut(Taking):
    """Empties one vessel into another. ``run`` carries it out."""

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str, target: str) -> None:
        super().__init__(cell, rng, item)
        self._target = target

    def run(self) -> Iterator[Stage]:
        """In up to ``ATTEMPTS`` attempts; a vessel that is in the gripper already stays there.

        Raises:
            ActionFailure: it did not succeed; the arm is at home, the gripper open unless it still
                holds the vessel it held before.
        """
        if self._held():
            yield from self._pour_what_is_held()
            return
        yield from self.come_home()
        for self._attempt in range(1, ATTEMPTS + 1):
            moved = len(self._banned)
            try:
                yield from self._try()
            except ActionFailure:
                yield from self.come_home()
                if self._attempt == ATTEMPTS or self._fruitless(moved):
                    raise
            else:
                return

    def _pour_what_is_held(self) -> Iterator[Stage]:
        yield self._stage("look")
        yield from self._pour(self._way(self._look_at(self._target)[self._target]))
        self._check_poured()

    def _try(self) -> Iterator[Stage]:
        yield self._stage("look")
        clouds = self._look_at(self._item, self._target)
        cloud = clouds[self._item]
        here = np.append((cloud.lowest + cloud.highest)[:2] / 2, cloud.lowest[2])
        pick = self._plan(cloud, here)
        yield from self._take(pick)
        try:
            way = self._way(clouds[self._target])
        except ActionFailure:
            yield from self._put_back(pick)
            raise
        yield from self._pour(way)
        yield from self._put_back(pick)
        yield from self.come_home()
        yield from self._come_to_rest()
        self._check_poured()
        if not self._cell.relations.holds(Relation("upright", (self._item,))):
            raise ActionFailure("check", f"{self._item} does not stand upright")

    def _way(self, goal: Cloud) -> Poured:
        """How to empty what is held over the middle of the target's mouth."""
        over = np.append((goal.lowest + goal.highest)[:2] / 2, goal.highest[2])
        cell = self._cell
        return Pouring(cell.physics, cell.collisions, self._rng).choose(self._item, over)

    def _pour(self, way: Poured) -> Iterator[Stage]:
        """Go there, tilt, and come back to where it began."""
        manipulator = self._cell.manipulator
        yield from self._during("carry", manipulator.follow(way.carry, CARRY_SPEED))
        yield from self._during("pour", manipulator.trace(way.tilt, TILTING))
        yield from self._during("pour", manipulator.wait(EMPTYING))
        yield from self._during("pour", manipulator.trace(way.tilt[::-1], CARRY_SPEED))
        if not self._held():
            raise ActionFailure("pour", f"slipped: {self._item} was lost while it was tilted")
        yield from self._during("carry", manipulator.follow(way.carry[::-1], CARRY_SPEED))

    def _put_back(self, pick: Pick) -> Iterator[Stage]:
        manipulator = self._cell.manipulator
        yield from self._during("put back", manipulator.trace(pick.lift[::-1], LIFT_SPEED))
        yield from self._during("release", manipulator.open())
        yield from self._during("retreat", manipulator.trace(pick.approach[::-1], FREE_SPEED))
        self._cell.look_at()  # It was last seen in the hand, and stands in the way home now.

    def _check_poured(self) -> None:
        if not self._cell.relations.holds(Relation("poured", (self._item, self._target))):
            raise ActionFailure(
                "check", f"too little of what was in {self._item} is in {self._target}"
            )
