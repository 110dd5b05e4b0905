"""Rotations in space, as matrices of shape (3, 3)."""

import mujoco
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def about(axis: Array, angle: float) -> Array:
    """The rotation about a unit vector, shape (3,), by an angle [rad]."""
    quaternion, turn = np.zeros(4), np.zeros(9)
    mujoco.mju_axisAngle2Quat(quaternion, axis, angle)
    mujoco.mju_quat2Mat(turn, quaternion)
    return turn.reshape(3, 3)
