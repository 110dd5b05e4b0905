"""Patch: what is held as it lies on a level top, and how much of that it covers from where."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.outline import hull
from app.worlds.simulators.mujoco.rectangle import Rectangle, turned_by

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

WALLED = 0.008
"""What rises so far above the level about it is a rim, which nothing is to be pushed against [m]."""
MARGIN = 0.001
"""So far from the edge of such a level, as it is seen, what is held is kept [m]."""
SEEN = 10
"""From fewer points no level is made out."""
THICK = 0.005
"""What is seen so near a height belongs to one level [m]."""
FACING_UP = 0.95
"""The upward part of the normal of what is level."""


class SeenLevel:
    """The widest level of an object, as the cameras see it."""

    def __init__(self, cloud: Cloud) -> None:
        """Find it.

        Raises:
            ActionFailure: none is seen.
        """
        points = _level(cloud)
        rectangle = Rectangle.about(points[:, :2])
        self.yaw, self.middle = rectangle.yaw, rectangle.middle
        self.height = float(np.median(points[:, 2]))
        """Above the table [m]."""
        self.spread = points[:, :2] - self.middle
        """Its points from its middle, shape (n, 2) [m]."""
        self.highest = float(cloud.highest[2])
        """Of all of the object, above the table [m]."""
        self.rim = hull(self.spread) if self.highest - self.height > WALLED else None
        """Half planes about it, from its middle, shape (k, 3); None where nothing rises there."""


@dataclass(frozen=True, slots=True, eq=False)
class Patch:
    """A rectangle on a level."""

    level: SeenLevel
    yaw: float
    """How its edges are turned [rad]."""
    half: Array
    """Half those edges, shape (2,) [m]."""

    @property
    def reach(self) -> Array:
        """How far the level reaches along its edges from the middle, shape (2,) [m]."""
        return np.abs(self._along_edges()).max(axis=0)

    @property
    def room(self) -> Array:
        """How far it gets along its edges from the middle, all of it on the level; (2,) [m]."""
        return np.maximum(0.0, self.reach - self.half)

    @property
    def axes(self) -> Array:
        """Where its edges point, unit vectors in the plane, shape (2, 2)."""
        return turned_by(self.yaw).T

    def fits(self, place: Array) -> bool:
        """Whether it is clear of the rim with its middle at a place, shape (2,) [m]."""
        rim = self.level.rim
        if rim is None:
            return True
        signs = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])
        corners = place + (signs * self.half) @ self.axes
        return float((corners @ rim[:, :2].T + rim[:, 2]).max()) < -MARGIN

    def covers(self, start: Array, end: Array) -> Mask:
        """What of the level's points it passes on a way between two places, along an edge; (n,)."""
        ways = np.stack([start, end]) @ self.axes.T  # (2, 2)
        low, high = ways.min(axis=0) - self.half, ways.max(axis=0) + self.half
        points = self._along_edges()
        return np.all((points >= low) & (points <= high), axis=1)

    def _along_edges(self) -> Array:
        return self.level.spread @ self.axes.T


def _level(cloud: Cloud) -> Array:
    """The points of the widest level, shape (n, 3) [m]."""
    up = cloud.points[cloud.normals[:, 2] > FACING_UP]
    heights = np.sort(up[:, 2])
    counts = np.searchsorted(heights, heights + THICK, side="right") - np.arange(len(heights))
    if counts.max(initial=0) < SEEN:
        raise ActionFailure("look", "no level top is seen")
    floor = heights[int(np.argmax(counts))]
    return up[(up[:, 2] >= floor) & (up[:, 2] <= floor + THICK)]
