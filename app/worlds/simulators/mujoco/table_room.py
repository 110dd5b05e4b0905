"""Free places on the table itself, and the middle of a top: where an object may be put exactly."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.destination import Destination, Landing
from app.worlds.simulators.mujoco.outline import Outlines
from app.worlds.simulators.mujoco.placement import BASE_RADIUS, REACH, SECTOR
from app.worlds.simulators.mujoco.rectangle import Rectangle
from app.worlds.simulators.mujoco.relief import CELL, STEP, Relief, Spot
from app.worlds.simulators.mujoco.scene_builder import ObjectBody

Array = NDArray[np.float64]
Allowed = Callable[[Array], NDArray[np.bool_]]
"""Which places, shape (n, n, 2) [m], an object's middle may come to; shape (n, n)."""

MARGIN_CELLS = 5
"""What stands on the table is grown to a square of so many cells, which keeps a gap to it."""
FREE = 0.003
"""An object that would lie no higher than this lies on the table [m]."""
AROUND = 0.16
"""The map reaches so far beyond the farthest spot that is tried [m]."""
APART, MOST = 0.03, 8
"""The spots that are tried for each turn are so far apart [m], and so many at most."""
_NOTHING = Cloud(np.array([[9.0, 9.0, 0.0]]), np.array([[0.0, 0.0, 1.0]]))
"""What is seen of an empty table: something far away."""
FARTHEST = REACH[1] + 0.03
"""From the robot's base [m]."""


class TableRoom(Destination):
    """Free places on the table, the nearest to a wish first."""

    def __init__(
        self,
        clouds: Mapping[str, Cloud],
        moved: str,
        wish: Array,
        within: float,
        allowed: Allowed = lambda places: np.ones(places.shape[:2], bool),
        farthest: float = FARTHEST,
    ) -> None:
        """Map what stands there.

        Args:
            clouds: everything seen, by name.
            moved: the object to be put there; it is no obstacle to itself.
            wish: where its middle should come to, shape (2,), base frame [m].
            within: how far from there it may [m].
            allowed: which of those places are meant.
            farthest: how far from the robot's base they may be [m].
        """
        self.centre, self.rim = np.asarray(wish, float), 0.0
        others = [cloud for name, cloud in clouds.items() if name != moved]
        # So many cells to either side that the wish itself is among those that are tried.
        cells = STEP * math.ceil((within + AROUND) / (STEP * CELL))
        self.relief = Relief(others or [_NOTHING], self.centre, (cells - 0.5) * CELL)
        self.relief.heights = ndimage.maximum_filter(self.relief.heights, size=MARGIN_CELLS)
        places = self.relief.places
        close = np.linalg.norm(places - self.centre, axis=-1) <= within + 1e-9
        self.relief.usable = close & _in_reach(places, farthest) & allowed(places)

    def landings(self, points: Array, middle: Array, turns: Array) -> list[Landing]:
        """Ways to put an object down on the table; see ``Destination.landings``."""
        found: list[Landing] = []
        relative = points - np.append(middle, points[:, 2].min())
        for turn in turns.tolist():
            cosine, sine = np.cos(turn), np.sin(turn)
            under = relative.copy()
            under[:, :2] = relative[:, :2] @ np.array([[cosine, sine], [-sine, cosine]])
            found += [Landing(turn, spot) for spot in self._spots(under)]
        if not found:
            x, y = self.centre
            raise ActionFailure("place", f"there is no room on the table at {x:.2f}, {y:.2f}")
        return sorted(found, key=lambda landing: landing.spot.cost)

    def _spots(self, under: Array) -> list[Spot]:
        spots = [spot for spot in self.relief.spots(under, self.centre) if spot.height < FREE]
        apart: list[Spot] = []
        for spot in spots:
            if all(math.hypot(spot.x - other.x, spot.y - other.y) > APART for other in apart):
                apart.append(replace(spot, height=0.0))
            if len(apart) == MOST:
                break
        return apart


class TopMiddle(Destination):
    """The middle of an object's top, whatever its shape: where another is stacked on it."""

    def __init__(
        self, outlines: Outlines, body: ObjectBody, clouds: Mapping[str, Cloud], moved: str
    ) -> None:
        """Find it; see ``Destination``.

        Raises:
            ActionFailure: the top is not flat enough.
        """
        super().__init__(outlines, body, clouds, moved)
        cloud = clouds[body.name]
        top = cloud.points[cloud.points[:, 2] > self.rim - 0.004][:, :2]
        rectangle = Rectangle.about(top)
        self._yaw, self.centre = rectangle.yaw, rectangle.middle

    def landings(self, points: Array, middle: Array, turns: Array) -> list[Landing]:
        """Over the middle, its edges along those of the support, or as near as the arm can."""
        del middle  # The box's middle is meant, not the mass's.
        own = Rectangle.about(points[:, :2]).yaw
        square = self._yaw - own + np.arange(-2, 3) * np.pi / 2
        spot = (float(self.centre[0]), float(self.centre[1]), self.rim)
        aligned = [Landing(turn, Spot(*spot, 0.01 * abs(turn))) for turn in square.tolist()]
        return aligned + [Landing(t, Spot(*spot, 0.05 + 0.01 * abs(t))) for t in turns.tolist()]


def _in_reach(places: Array, farthest: float) -> NDArray[np.bool_]:
    distance = np.hypot(places[..., 0], places[..., 1])
    bearing = np.abs(np.arctan2(places[..., 1], places[..., 0]))
    return (distance > BASE_RADIUS + 0.08) & (distance < farthest) & (bearing < SECTOR)
