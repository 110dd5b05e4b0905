"""Shoving: look, push an object over the table, check."""

from collections.abc import Iterator

import numpy as np

from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import FREE_SPEED, LIFT_SPEED, Array, Manoeuvre
from app.worlds.simulators.mujoco.pushing import Pushing
from app.worlds.simulators.mujoco.workcell import Workcell

ATTEMPTS = 3
STROKE_SPEED = 0.15
"""Slow, so that what is round does not run ahead; a fraction of the joints' limits."""
ENOUGH = 0.5
"""An object has been pushed once it moved this share of the distance."""


class Shoving(Manoeuvre):
    """Pushes one object. ``run`` carries it out."""

    _item: str

    def __init__(
        self, cell: Workcell, rng: np.random.Generator, item: str, towards: Array, distance: float
    ) -> None:
        """Describe it.

        Args:
            cell: the robot's surroundings.
            rng: the action's own stream of random numbers.
            item: what is pushed.
            towards: unit vector in the plane of the table, shape (2,).
            distance: how far [m].
        """
        super().__init__(cell, rng, item)
        self._towards = towards
        self._distance = distance

    def run(self) -> Iterator[Stage]:
        """Push until the object has moved, in up to ``ATTEMPTS`` strokes.

        Raises:
            ActionFailure: it did not; the arm is at home.
        """
        yield from self.come_home()
        begin = self._along()
        for self._attempt in range(1, ATTEMPTS + 1):
            yield self._stage("look")
            left = self._distance - (self._along() - begin)
            yield from self._stroke(max(left, 0.02))
            yield from self.come_home()
            yield from self._come_to_rest()
            moved = self._along() - begin
            if moved > ENOUGH * self._distance:
                return
        raise ActionFailure("check", f"{self._item} moved only {moved:.2f} m")  # pyright: ignore[reportPossiblyUnboundVariable]

    def _along(self) -> float:
        return float(self._cell.relations.place(self._item) @ self._towards)

    def _stroke(self, distance: float) -> Iterator[Stage]:
        clouds = self._look_at(self._item)
        self._cell.collisions.refresh()
        pushing = Pushing(self._cell.collisions, self._cell.physics.joints, self._rng)
        push = pushing.choose(self._item, clouds, self._towards, distance)
        manipulator = self._cell.manipulator
        yield from self._during("reach", manipulator.open(push.opening, 0.2))
        yield from self._during("reach", manipulator.follow(push.reach, FREE_SPEED))
        yield from self._during("lower", manipulator.trace(push.lower, LIFT_SPEED))
        yield from self._during("push", manipulator.trace(push.stroke, STROKE_SPEED))
        yield from self._during("retreat", manipulator.trace(push.rise, LIFT_SPEED))
