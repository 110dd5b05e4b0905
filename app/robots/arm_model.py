"""ArmModel: what must be known of an arm to send it anywhere."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from app.domain.robot import RobotLimits

Array = NDArray[np.float64]


class ArmModel(Protocol):
    """An arm with two fingers."""

    limits: RobotLimits

    @property
    def arm_part(self) -> slice:
        """The arm's joints in the simulated positions."""
        ...

    @property
    def finger_part(self) -> slice:
        """The gripper's joints there."""
        ...

    def opening_at(self, finger_joints: Array) -> float:
        """How far each finger is from the middle, on average, at these joints [m]."""
        ...

    def forward(self, joints: Array) -> Array:
        """The tool's pose in the base frame, shape (4, 4), at these angles, shape (n,) [rad]."""
        ...
