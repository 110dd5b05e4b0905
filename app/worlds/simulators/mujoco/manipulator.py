"""Manipulator: commands to the arm and its gripper, each carried out while the caller looks on."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.motion import timed
from app.worlds.simulators.mujoco.physics import Physics

Array = NDArray[np.float64]

LOOK_IN = 0.1
"""Every command yields this often [s of simulated time]."""


class Manipulator:
    """The arm and its gripper. Commands are generators: each yields every ``LOOK_IN`` seconds."""

    def __init__(self, physics: Physics) -> None:
        self.physics = physics
        self._timestep = physics.model.opt.timestep
        self._look_in = physics.steps_in(LOOK_IN)
        bias = physics.model.actuator_biasprm[physics.arm.arm_part]
        # A joint's servo pulls with kp (ctrl - q) - kd dq: leading by kd/kp dq makes up for its lag.
        self._lead = bias[:, 2] / bias[:, 1]

    def follow(self, path: Array, speed: float) -> Iterator[None]:
        """Move through the corner points of a path, shape (n, joints) [rad], stopping at each.

        A path with many points close together, a line of the tool, is one motion: see ``trace``.
        """
        for start, end in pairwise(path):
            yield from self.trace(np.array([start, end]), speed)

    def trace(self, path: Array, speed: float) -> Iterator[None]:
        """Move along a path in one motion, without stopping between, at a fraction of full speed."""
        if float(np.abs(np.diff(path, axis=0)).max(initial=0.0)) < 1e-6:
            return
        points, velocities = timed(self.physics.arm, path, speed, self._timestep)
        for count, joints in enumerate(points + self._lead * velocities, start=1):
            self.physics.command(joints=joints)
            self.physics.step()
            if count % self._look_in == 0:
                yield
        self.physics.command(joints=path[-1])
        yield

    def wait(self, seconds: float) -> Iterator[None]:
        """Keep still [s]."""
        return self.grip(self.physics.commanded_opening, seconds)

    def grip(self, opening: float, seconds: float, closing: float | None = None) -> Iterator[None]:
        """Bring each finger to a distance from the middle.

        Args:
            opening: that distance [m].
            seconds: how long to go on, holding it [s].
            closing: in how much of that time to get there; None for all of it [s].
        """
        before = self.physics.commanded_opening
        ramp = self.physics.steps_in(closing or seconds)
        for count in range(1, self.physics.steps_in(seconds) + 1):
            share = min(1.0, count / ramp)
            self.physics.command(opening=before + (opening - before) * share)
            self.physics.step()
            if count % self._look_in == 0:
                yield
        yield

    def open(self, opening: float | None = None, seconds: float = 0.3) -> Iterator[None]:
        """Open the gripper, wholly or so far that each finger is ``opening`` from the middle [m]."""
        widest = self.physics.arm.largest_opening
        return self.grip(widest if opening is None else opening, seconds)
