"""Wiping down: take a cloth, press it on an object's top, draw it over, put it back, check."""

from collections.abc import Iterator

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.borrowing import Borrowing
from app.worlds.actions.manoeuvre import CARRY_SPEED, LIFT_SPEED
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.wiping import Pass, Wiping

STROKING = 0.3
"""Fraction of the joints' limits while it is drawn over the top."""
FEELING = 0.3
"""The same while it comes down on it."""
FEEL, DEEPEST = 0.001, 0.018
"""It comes down by such steps, and so far below where it should have been met at most [m]."""
HELD_UP = 0.0004
"""What lies on something keeps the gripper so far above where it is told to be [m]."""
STILL = 0.3
"""So long the arm comes to rest before that is measured [s]."""


class WipingDown(Borrowing[tuple[Pass, ...]]):
    """Wipes the top of one object with another. ``run`` carries it out."""

    def _way(self, goal: Cloud) -> tuple[Pass, ...]:
        """How to draw what is held over the level top of the target."""
        cell = self._cell
        wiping = Wiping(cell.physics, cell.collisions, self._rng)
        return wiping.choose(self._item, self._target, goal)

    def _use(self, way: tuple[Pass, ...]) -> Iterator[Stage]:
        """Pass after pass, then back to where it began, whatever came of it."""
        manipulator = self._cell.manipulator
        failure: ActionFailure | None = None
        done: list[Pass] = []
        for each in way:
            yield from self._during("carry", manipulator.follow(each.carry, CARRY_SPEED))
            done.append(each)
            try:
                yield from self._wipe(each)
            except ActionFailure as error:
                failure = error
            yield from self._rise(each)
            if failure is not None:
                break
        for each in reversed(done):
            yield from self._during("carry", manipulator.follow(each.carry[::-1], CARRY_SPEED))
        if failure is not None and not self._wiped():
            raise failure

    def _wipe(self, each: Pass) -> Iterator[Stage]:
        """One pass, from above its middle."""
        manipulator = self._cell.manipulator
        yield from self._during("lower", manipulator.trace(each.lower, LIFT_SPEED))
        yield from self._during("wipe", manipulator.wait(STILL))
        free = self._held_up()
        yield from self._press(free)
        for step in np.diff(each.course, axis=0, prepend=np.zeros((1, 2))):
            yield from self._go((float(step[0]), float(step[1]), 0.0), STROKING)
            yield from self._press(free)

    def _rise(self, each: Pass) -> Iterator[Stage]:
        """Up again to where it was lowered from.

        Raises:
            ActionFailure: what was held is lost.
        """
        joints = self._cell.physics.commanded_joints
        back = np.array([joints, *each.lower[::-1]])
        yield from self._during("lift", self._cell.manipulator.trace(back, LIFT_SPEED))
        if not self._held():
            raise ActionFailure("wipe", f"slipped: {self._item} was lost while wiping")

    def _press(self, free: float) -> Iterator[Stage]:
        """Go down until the target bears what is held, which gives way in the fingers.

        Args:
            free: how far the gripper was held up where nothing bore it [m].

        Raises:
            ActionFailure: the target is not met.
        """
        for _ in range(round(DEEPEST / FEEL)):
            if self._held_up() - free > HELD_UP:
                yield from self._during("wipe", self._cell.manipulator.wait(STILL))
                if self._held_up() - free > HELD_UP:  # It was no swing of the arm.
                    return
            yield from self._go((0.0, 0.0, -FEEL), FEELING)
        raise ActionFailure("wipe", f"{self._item} did not come down on {self._target}")

    def _go(self, step: tuple[float, float, float], speed: float) -> Iterator[Stage]:
        """Straight on by a step [m], from where the gripper is told to be."""
        arm, start = self._cell.physics.arm, self._cell.physics.commanded_joints
        pose = arm.forward(start)
        end = pose.copy()
        end[:3, 3] += step
        path = arm.line(pose, end, start)
        if path is None:
            raise ActionFailure("wipe", f"the arm cannot follow {self._target}'s top")
        yield from self._during("wipe", self._cell.manipulator.trace(path, speed))

    def _held_up(self) -> float:
        """How far the gripper is above where it is told to be [m]."""
        physics = self._cell.physics
        told = physics.arm.forward(physics.commanded_joints)
        return float(physics.arm.forward(physics.joints)[2, 3] - told[2, 3])

    def _check_done(self) -> None:
        if not self._wiped():
            raise ActionFailure("check", f"too little of {self._target} was wiped")
        if not self._cell.relations.holds(Relation("upright", (self._target,))):
            raise ActionFailure("check", f"{self._target} was knocked over")

    def _wiped(self) -> bool:
        return self._cell.relations.holds(Relation("wiped", (self._target,)))
