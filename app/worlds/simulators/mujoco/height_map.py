"""Height map: how high what was seen stands above every spot of the table, and what it is."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from app.worlds.simulators.mujoco.cloud import Cloud

Array = NDArray[np.float64]

CELL = 0.006
"""Distance between neighbouring spots [m]."""
CORNER = (-0.2, -0.75)
"""x and y of the first spot, base frame [m]."""
COUNT = (184, 251)
"""Spots along x and y."""
TABLE = "the table"


class HeightMap:
    """Heights on a square grid over the table; spots where nothing was seen are at its level, 0."""

    def __init__(self, clouds: Mapping[str, Cloud]) -> None:
        self.heights: Array = np.zeros(COUNT)
        self._owners = np.full(COUNT, -1)
        self._names = tuple(clouds)
        for index, cloud in enumerate(clouds.values()):
            own = np.zeros(COUNT)
            cells, inside = _cells(cloud.points)
            np.maximum.at(own, tuple(cells[inside].T), cloud.points[inside, 2])
            # A camera's pixels may be farther apart than the spots: small holes are filled.
            own = np.asarray(ndimage.grey_closing(own, 3), float)
            higher = own > self.heights
            self._owners[higher] = index
            self.heights = np.maximum(self.heights, own)

    def below(self, points: Array) -> Array:
        """The heights under points (n, 3), shape (n,) [m]; off the grid, the table's."""
        cells, inside = _cells(points)
        cells[~inside] = 0
        return np.where(inside, self.heights[cells[:, 0], cells[:, 1]], 0.0)

    def owner(self, place: Array) -> str:
        """What stands at a place, shape (3,), or next to it."""
        (cell,), (inside,) = _cells(place[None])
        if not inside:
            return TABLE
        x, y = cell.tolist()
        around = self._owners[max(0, x - 2) : x + 3, max(0, y - 2) : y + 3]
        found = around[around >= 0]
        return self._names[np.bincount(found).argmax()] if len(found) else TABLE


def _cells(points: Array) -> tuple[NDArray[np.int_], NDArray[np.bool_]]:
    cells = np.round((points[:, :2] - CORNER) / CELL).astype(int)
    return cells, np.asarray(((cells >= 0) & (cells < COUNT)).all(axis=1), bool)
