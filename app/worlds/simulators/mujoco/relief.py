"""Relief: a height map of what has been seen, and where in it an object could be put down."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from app.worlds.simulators.mujoco.cloud import Cloud

Array = NDArray[np.float64]

CELL = 0.006
"""Edge of a cell [m]."""
STEP = 2
"""Every so many cells, a spot is tried."""
OVERHANG_COST = 0.15
"""What it costs, in metres of height, if all of the object overhangs the edge."""
CENTRE_COST = 0.12
"""What it costs, in metres of height, to be a metre off the middle."""
ACROSS_COST = 0.1
"""What it costs, in metres of height, to lie across the rim of a container."""
SUNK = 0.004
"""What lies no deeper below the rim lies on it [m]."""
LEVEL = 0.006
"""Cells so little lower than what bears the object bear it as well [m]."""
LEVER = 0.04
"""What bears an object must be so far to one side of its middle for it to tip [m]."""
FLAT = 0.002
"""Heights that differ by no more than this are one level [m]."""


@dataclass(frozen=True, slots=True)
class Spot:
    """Where an object could come to rest."""

    x: float
    y: float
    """Place of the object's centre in the base frame [m]."""
    height: float
    """Where its lowest point would then be, above the table [m]."""
    cost: float
    """Lower is better [m]."""


class Relief:
    """Heights over the table on a square grid about a centre, and which cells may be used."""

    def __init__(self, clouds: Iterable[Cloud], centre: Array, half: float) -> None:
        """Take the highest point seen in each cell; what was not seen is as high as next to it.

        Args:
            clouds: everything that stands there.
            centre: middle of the grid in the base frame, shape (2,) [m].
            half: half the grid's edge [m].
        """
        self._count = 2 * math.ceil(half / CELL) + 1
        self._origin = np.asarray(centre) - (self._count // 2) * CELL
        seen = np.full((self._count, self._count), -np.inf)
        for cloud in clouds:
            cells = self._cells(cloud.points[:, :2])
            inside = self._contains(cells)
            np.maximum.at(seen, tuple(cells[inside].T), cloud.points[inside, 2])
        # The table itself is not among the clouds: away from all points its level, 0, is taken.
        self._unknown = ~np.isfinite(seen)
        distance, nearest = ndimage.distance_transform_edt(self._unknown, return_indices=True)  # pyright: ignore[reportGeneralTypeIssues]
        self._beside: Array = seen[tuple(nearest)]
        self.heights: Array = np.where(distance <= 2, self._beside, 0.0)
        axis = np.arange(self._count) * CELL
        x, y = np.meshgrid(self._origin[0] + axis, self._origin[1] + axis, indexing="ij")
        self.places: Array = np.stack([x, y], axis=-1)  # (n, n, 2) in the base frame [m]
        self.usable: NDArray[np.bool_] = np.zeros_like(self._unknown)

    def allow(self, cells: NDArray[np.bool_]) -> None:
        """Let an object's centre be put over these cells, shape (n, n).

        What of them was not seen is taken to be as high as what was seen next to it.
        """
        self.usable = cells
        self.heights = np.where(cells & self._unknown, self._beside, self.heights)

    def spots(self, under: Array, centre: Array, rim: float = np.inf) -> list[Spot]:
        """Places for an object, the best first.

        Args:
            under: points of the object, relative to its centre (x, y) and its lowest point (z),
                shape (n, 3) [m].
            centre: the preferred place, shape (2,) [m].
            rim: height of a container's edge; what would lie across it is not in it [m].
        """
        at = np.argwhere(self.usable)
        at = at[(at % STEP == 0).all(axis=1)]
        if len(at) == 0:
            return []
        offsets = np.round(under[:, :2] / CELL).astype(int)
        offsets, under_heights = _lower_hull(offsets, under[:, 2])
        cells = at[:, None, :] + offsets[None, :, :]  # (spots, points, 2)
        on_grid = self._contains(cells)
        clipped = np.clip(cells, 0, self._count - 1)
        ground = np.where(on_grid, self.heights[clipped[..., 0], clipped[..., 1]], 0.0)
        gaps = ground - under_heights
        heights = gaps.max(axis=1)
        usable = self.usable[clipped[..., 0], clipped[..., 1]] & on_grid
        overhang = 1 - usable.mean(axis=1)
        places = self.places[at[:, 0], at[:, 1]]
        away = np.linalg.norm(places - centre, axis=1)
        cost = heights + OVERHANG_COST * overhang + CENTRE_COST * away
        high = heights > rim - SUNK
        if high.any():
            # Borne on one side of its middle only, it tips and slides in; borne on both, it stays.
            bears = gaps[high] > heights[high, None] - LEVEL
            lever = (bears.astype(float) @ offsets) * CELL / bears.sum(axis=1, keepdims=True)
            cost[high] += ACROSS_COST * (np.linalg.norm(lever, axis=1) < LEVER)
        order = np.argsort(cost, kind="stable")
        return [
            Spot(float(places[k, 0]), float(places[k, 1]), float(heights[k]), float(cost[k]))
            for k in order
        ]

    def top_level(self, cloud: Cloud) -> NDArray[np.bool_]:
        """The cells of the largest level area at the top of what the cloud shows."""
        cells = self._cells(cloud.points[:, :2])
        cells = cells[self._contains(cells)]
        own = np.zeros_like(self.usable)
        own[tuple(cells.T)] = True
        own = np.asarray(ndimage.binary_closing(own, iterations=2), bool)
        level = own & (self.heights > float(np.quantile(cloud.points[:, 2], 0.98)) - FLAT)
        found, count = ndimage.label(level)  # pyright: ignore[reportGeneralTypeIssues]
        areas: NDArray[np.int32] = np.asarray(found, np.int32)
        if count == 0:
            return level
        largest = 1 + int(np.argmax(np.bincount(areas.ravel())[1:]))
        return areas == largest

    def _cells(self, places: Array) -> NDArray[np.int_]:
        return np.round((places - self._origin) / CELL).astype(int)

    def _contains(self, cells: NDArray[np.int_]) -> NDArray[np.bool_]:
        return np.asarray(((cells >= 0) & (cells < self._count)).all(axis=-1))


def _lower_hull(offsets: NDArray[np.int_], heights: Array) -> tuple[NDArray[np.int_], Array]:
    """The lowest point over each cell."""
    low = offsets.min(axis=0)
    local = offsets - low
    lowest = np.full(local.max(axis=0) + 1, np.inf)
    np.minimum.at(lowest, tuple(local.T), heights)
    cells = np.argwhere(np.isfinite(lowest))
    return cells + low, lowest[tuple(cells.T)]
