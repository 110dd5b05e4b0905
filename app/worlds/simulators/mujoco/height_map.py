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
SEAM = 2
"""So far about an object, in spots, filling holes may change something."""
TABLE = "the table"


class HeightMap:
    """Heights on a square grid over the table; spots where nothing was seen are at its level, 0."""

    def __init__(self, clouds: Mapping[str, Cloud]) -> None:
        self.heights: Array = np.zeros(COUNT)
        self._owners = np.full(COUNT, -1)
        self._names = tuple(clouds)
        for index, cloud in enumerate(clouds.values()):
            cells, inside = _cells(cloud.points)
            # Only the part of the grid that the cloud is over, with a seam for what is filled.
            (low, high), _ = _cells(np.stack([cloud.lowest, cloud.highest]))
            low, high = (low - SEAM).clip(0, COUNT), (high + 1 + SEAM).clip(0, COUNT)
            if not inside.any():
                continue
            own = np.zeros(high - low)
            np.maximum.at(own, tuple((cells[inside] - low).T), cloud.points[inside, 2])
            # A camera's pixels may be farther apart than the spots: small holes are filled.
            own = np.asarray(ndimage.grey_closing(own, 3), float)
            window = np.s_[low[0] : high[0], low[1] : high[1]]
            higher = own > self.heights[window]
            self._owners[window][higher] = index
            self.heights[window][higher] = own[higher]

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
