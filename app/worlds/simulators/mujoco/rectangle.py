"""Rectangle: the smallest one about points, seen from above."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Rectangle:
    """A rectangle in the plane of the table."""

    middle: Array
    """Shape (2,), base frame [m]."""
    yaw: float
    """How its edges are turned, in [0, pi/2) [rad]."""
    half: Array
    """Half its edges, along ``yaw`` and across, shape (2,) [m]."""

    @classmethod
    def about(cls, points: Array) -> "Rectangle":
        """The smallest rectangle about points, shape (n, 2) [m]."""
        angles = np.linspace(0, np.pi / 2, 46)[:-1]
        across = points @ np.stack([np.cos(angles), np.sin(angles)])  # (n, 45)
        along = points @ np.stack([-np.sin(angles), np.cos(angles)])
        yaw = float(angles[np.argmin(np.ptp(across, axis=0) * np.ptp(along, axis=0))])
        turn = turned_by(yaw)
        local = points @ turn
        low, high = local.min(axis=0), local.max(axis=0)
        return cls(turn @ ((low + high) / 2), yaw, (high - low) / 2)


def turned_by(yaw: float) -> Array:
    """The rotation by an angle [rad], shape (2, 2)."""
    return np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
