"""Level top: the part of an object's upper side that lies flat, read from its model."""

import math
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.scene_builder import CELLS, ObjectBody
from app.worlds.simulators.mujoco.solid import COLLISION_GROUP
from app.worlds.simulators.mujoco.surface import surface_points

Array = NDArray[np.float64]

ROWS = math.isqrt(CELLS)
"""Cells along either edge of an object's bounding box, seen from above."""
BAND = 0.0005
"""Heights that differ by no more than this are level with one another [m]."""
ALOFT = 50.0
"""An object is looked at from above where nothing else is: so high up [m]."""
OVER = 0.01
"""A look begins so far above the object [m]."""
GROUPS = (np.arange(6) == COLLISION_GROUP).astype(np.uint8)
"""Of the geoms that are looked at: what collides, shape (6,)."""


@dataclass(frozen=True, slots=True, eq=False)
class LevelTop:
    """The cells of the level that is widest: a plate's foot, a tray's floor, a book's cover."""

    cells: NDArray[np.int_]
    """Which of ``CELLS``, shape (n,)."""
    middles: Array
    """Of those cells, on the surface, shape (n, 3), in the object's frame [m]."""
    area: float
    """[m²]."""


def level_top(model: mujoco.MjModel, body: ObjectBody) -> LevelTop:
    """What of an object's collision geoms is met from straight above, on one level."""
    data = mujoco.MjData(model)
    address = body.qpos_address
    data.qpos[address : address + 7] = (0.0, 0.0, ALOFT, 1.0, 0.0, 0.0, 0.0)
    if body.joint is not None:
        data.qpos[model.jnt_qposadr[body.joint]] = body.start
    mujoco.mj_kinematics(model, data)
    points = np.concatenate([surface_points(model, data, part) for part in body.parts])
    low, high = points.min(axis=0), points.max(axis=0)
    shares = (np.arange(ROWS) + 0.5) / ROWS
    x, y = (low[axis] + shares * (high[axis] - low[axis]) for axis in (0, 1))
    places = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    heights = np.array([_height(model, data, place, high[2] + OVER) for place in places])
    heights[heights < low[2]] = -np.inf  # past the object, down to the table
    cells = _widest_level(heights)
    middles = np.column_stack([places[cells], heights[cells] - ALOFT])
    area = float(np.prod((high - low)[:2])) * len(cells) / CELLS
    return LevelTop(cells, middles, area)


def _height(model: mujoco.MjModel, data: mujoco.MjData, place: Array, above: float) -> float:
    start, down = np.append(place, above), np.array([0.0, 0.0, -1.0])
    met = np.zeros(1, np.int32)
    distance = mujoco.mj_ray(model, data, start, down, GROUPS, False, -1, met)
    return above - distance if met[0] >= 0 else -np.inf


def _widest_level(heights: Array) -> NDArray[np.int_]:
    """The cells of the band of heights that holds most of them, the highest of several."""
    seen = np.sort(heights[np.isfinite(heights)])
    counts = np.searchsorted(seen, seen + BAND, side="right") - np.arange(len(seen))
    if len(seen) == 0:
        return np.zeros(0, int)
    floor = seen[len(seen) - 1 - int(np.argmax(counts[::-1]))]
    return np.flatnonzero((heights >= floor) & (heights <= floor + BAND))
