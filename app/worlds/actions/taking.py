"""Taking: an object into the gripper, from wherever it lies."""

from collections.abc import Callable, Iterator

import numpy as np

from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import (
    CLOSE_SPEED,
    CLOSING_SECONDS,
    EMPTY,
    FREE_SPEED,
    LIFT_SPEED,
    PAUSE,
    SQUEEZE_SECONDS,
    Array,
    Manoeuvre,
)
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.grasp import Grasp
from app.worlds.simulators.mujoco.picking import Pick, Picking
from app.worlds.simulators.mujoco.workcell import Workcell

ATTEMPTS = 3
Grasps = list[Grasp]


class Taking(Manoeuvre):
    """Takes hold of an object and lifts it. ``take_home`` carries it out."""

    _item: str

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str) -> None:
        super().__init__(cell, rng, item)
        self._banned: Grasps = []

    def take_home(self) -> Iterator[Stage]:
        """Take the object and bring it home, in up to ``ATTEMPTS`` attempts.

        Raises:
            ActionFailure: it did not succeed; the gripper is open and the arm at home.
        """
        yield from self._in_attempts(self._take_and_come_home)

    def _take_and_come_home(self) -> Iterator[Stage]:
        yield self._stage("look")
        cloud = self._look_at(self._item)[self._item]
        here = np.append((cloud.lowest + cloud.highest)[:2] / 2, cloud.lowest[2])
        yield from self._take(self._plan(cloud, here))
        yield from self._go_home_loaded(self._item)

    def _in_attempts(
        self, attempt: Callable[[], Iterator[Stage]], reached: Callable[[], bool] = lambda: False
    ) -> Iterator[Stage]:
        """From home, up to ``ATTEMPTS`` times until it goes well, or is ``reached`` all the same.

        Raises:
            ActionFailure: it did not, or nothing is left to try; the arm is at home.
        """
        yield from self.come_home()
        for self._attempt in range(1, ATTEMPTS + 1):
            moved = len(self._banned)
            try:
                yield from attempt()
            except ActionFailure:
                yield from self.come_home()
                if reached():
                    return
                if self._attempt == ATTEMPTS or self._fruitless(moved):
                    raise
            else:
                return

    def _fruitless(self, moved: int) -> bool:
        """Whether nothing was tried since so many grasps were; else earlier ones may be again."""
        if len(self._banned) > moved:
            return False
        if not self._banned:
            return True
        self._banned.clear()
        return False

    def _plan(self, cloud: Cloud, goal: Array) -> Pick:
        """A pick for carrying the object to a place, shape (3,), base frame [m]."""
        self._cell.collisions.refresh()
        picking = Picking(self._cell.collisions, self._cell.physics.joints, goal, self._rng)
        return picking.choose(self._item, cloud, self._banned)

    def _take(self, pick: Pick) -> Iterator[Stage]:
        manipulator = self._cell.manipulator
        yield from self._during("reach", manipulator.follow(pick.reach, FREE_SPEED))
        self._banned.append(pick.grasp)
        if pick.opening < self._cell.physics.arm.largest_opening:
            yield from self._during("reach", manipulator.open(pick.opening, 0.15))
        yield from self._during("approach", manipulator.trace(pick.approach, CLOSE_SPEED))
        yield from self._during("approach", manipulator.wait(PAUSE))
        closing = manipulator.grip(0.0, SQUEEZE_SECONDS, CLOSING_SECONDS)
        yield from self._during("grasp", closing)
        yield from self._during("lift", manipulator.trace(pick.lift, LIFT_SPEED))
        yield from self._during("lift", manipulator.wait(PAUSE))
        if not self._held():
            missed = self._cell.physics.opening < EMPTY
            how = "the fingers closed on nothing" if missed else "it slipped"
            raise ActionFailure("lift", f"{'missed' if missed else 'slipped'}: {how}")
