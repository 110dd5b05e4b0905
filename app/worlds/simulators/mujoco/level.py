"""Level: whether the arm keeps what it carries upright enough that nothing runs out of it."""

import math

import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.righting import up_axis

Array = NDArray[np.float64]

STEEPEST = math.cos(math.radians(40))
"""A vessel that leans farther may spill: the cosine of the angle from upright."""


class Level:
    """One held vessel, as it is in the gripper now."""

    def __init__(self, physics: Physics, name: str) -> None:
        self._arm = physics.arm
        tool = self._arm.forward(physics.joints)
        self._axis = tool[:3, :3].T @ up_axis(physics, name)  # in the tool's frame

    def lost(self, joints: Array) -> bool:
        """Whether the vessel leans too far at these joint angles, shape (joints,) [rad]."""
        return float(self._arm.forward(joints)[2, :3] @ self._axis) < STEEPEST
