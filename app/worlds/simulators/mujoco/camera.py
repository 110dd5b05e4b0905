"""Camera: where it stands, and which way each of its pixels looks."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Camera:
    """Where a camera is, what it looks at [m, base frame], and its vertical field of view [rad]."""

    position: tuple[float, float, float]
    target: tuple[float, float, float]
    field_of_view: float = math.radians(60)

    def axes(self) -> Array:
        """Unit vectors to the right, up and forward in the base frame, rows, shape (3, 3)."""
        forward = np.subtract(self.target, self.position)
        forward /= np.linalg.norm(forward)
        right = np.array([forward[1], -forward[0], 0.0]) / math.hypot(forward[0], forward[1])
        up = np.array(
            [
                right[1] * forward[2] - right[2] * forward[1],
                right[2] * forward[0] - right[0] * forward[2],
                right[0] * forward[1] - right[1] * forward[0],
            ]
        )
        return np.stack([right, up, forward])

    def tangents(self, width: int, height: int) -> tuple[Array, Array]:
        """What the pixels' columns (width,) and rows (height,) are off the axis, at distance 1."""
        half = math.tan(self.field_of_view / 2)
        return (
            np.linspace(-half, half, width) * (width / height),
            np.linspace(half, -half, height),
        )

    def zoomed(self, centre: Array, radius: float) -> "Camera":
        """The same camera, turned and zoomed onto a ball [m]."""
        distance = float(np.linalg.norm(centre - self.position))
        angle = 2 * math.asin(min(0.9, radius / distance))
        x, y, z = centre.tolist()
        return Camera(self.position, (x, y, z), angle)


CAMERAS = (
    Camera((0.95, -0.55, 0.65), (0.5, 0.0, 0.02)),
    Camera((0.95, 0.55, 0.65), (0.5, 0.0, 0.02)),
    Camera((0.35, 0.0, 1.1), (0.5, 0.0, 0.0)),
    Camera((0.05, -0.55, 0.6), (0.5, 0.0, 0.0)),
    Camera((0.05, 0.55, 0.6), (0.5, 0.0, 0.0)),
)
"""Two in front, one above, one over each of the robot's shoulders."""
LOW_CAMERAS = (
    Camera((0.9, -0.65, 0.1), (0.4, 0.0, 0.15)),
    Camera((0.9, 0.65, 0.1), (0.4, 0.0, 0.15)),
    Camera((0.1, 0.7, 0.1), (0.4, 0.0, 0.15)),
)
"""Just above the table; they look at what is lifted, whose underside the others do not see."""
