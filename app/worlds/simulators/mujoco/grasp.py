"""Grasps: where two parallel fingers can take hold of what a point cloud shows.

An antipodal grasp presses on two surfaces that face away from each other. Candidates come from a
grid over approach direction, turn about it, place along the object and depth. The points between
the finger pads give the width, and their normals the quality.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.cloud import Cloud

Array = NDArray[np.float64]

STEEP = (0.0,)
SLANTED = (math.radians(20),)
FLAT = (math.radians(40), math.radians(60), math.radians(80))
"""How far the approach is tilted from straight down [rad]."""
WIDEST = 0.072
"""The widest thing the fingers are asked to take, a little less than they open [m]."""
TIGHT = 0.066
"""From this width on, the fingers have hardly any play [m]."""
PAD_HALF_WIDTH = 0.011
PAD_HALF_HEIGHT = 0.0085
"""Half the size of a finger pad, across and along the approach [m]."""
DEEPEST = 0.036
"""How far the finger tips reach below the top of the object; deeper, the palm would touch [m]."""
POINTS = 900
"""A cloud is thinned to so many points."""
FEWEST = 4
"""So many points must be between the pads."""
GAP = 0.016
"""A larger empty space between neighbouring points parts two walls of a hollow thing [m]."""
SKIN = 0.003
"""Points this close to the outermost one are what a pad touches [m]."""
TABLE_GAP = 0.0015
"""The pads stay this far above the table [m]."""
LOWEST_QUALITY = 0.3
LOOK_AHEAD = 12
"""For each distinct grasp wanted, so many are looked at."""


@dataclass(frozen=True, slots=True, eq=False)
class Grasp:
    """One way of taking hold."""

    tool: Array
    """Pose of the tool in the base frame, shape (4, 4) [m]."""
    width: float
    """What will be between the fingers [m]."""
    quality: float
    """Mean alignment of the touched surfaces with the closing direction, at most 1."""
    score: float
    """Higher is better; comparable within one cloud."""

    def like(self, other: "Grasp", within: float) -> bool:
        """Whether both grip at about the same place [m] in about the same direction."""
        return bool(_alike(self.tool[None], other.tool, within)[0])


@dataclass(frozen=True, slots=True)
class _Squeeze:
    """What the pads would touch at one place: span in the closing direction, and how well."""

    low: float
    high: float
    quality: float
    sideways: float
    """How far the touched spots lie off the pads' middle, both added [m]."""
    split: bool
    """Whether there is an empty space between the pads somewhere at this place."""


def candidates(cloud: Cloud, tilts: Iterable[float], rng: np.random.Generator) -> list[Grasp]:
    """Grasps of what the cloud shows, the best first.

    Args:
        cloud: the object's surface, base frame.
        tilts: the tilts of the approach from straight down to try [rad].
        rng: thins a large cloud.
    """
    chosen = slice(None)
    if len(cloud) > POINTS:
        chosen = rng.choice(len(cloud), POINTS, replace=False)
    points, normals = cloud.points[chosen], cloud.normals[chosen]
    middle = (points.min(axis=0) + points.max(axis=0)) / 4 + points.mean(axis=0) / 2
    found: list[Grasp] = []
    for rotation, tilt in _orientations(points, tilts):
        found += _grasps_at(points, normals, rotation, tilt, middle)
    found.sort(key=lambda grasp: -grasp.score)
    return found


def distinct(grasps: Sequence[Grasp], limit: int) -> list[Grasp]:
    """The first ``limit`` of them that are not nearly the same as an earlier one."""
    chosen: list[Grasp] = []
    grasps = grasps[: limit * LOOK_AHEAD]
    if not grasps:
        return chosen
    tools = np.stack([grasp.tool for grasp in grasps])
    free = np.ones(len(grasps), bool)
    for index, grasp in enumerate(grasps):
        if not free[index]:
            continue
        chosen.append(grasp)
        if len(chosen) == limit:
            break
        free &= ~_alike(tools, grasp.tool, within=0.008)
    return chosen


def _alike(tools: Array, tool: Array, within: float) -> NDArray[np.bool_]:
    """Which of the tool poses, shape (n, 4, 4), grip at about the same place in the same way."""
    near = ((tools[:, :3, 3] - tool[:3, 3]) ** 2).sum(axis=1) < within**2
    same_closing = np.abs(tools[:, :3, 1] @ tool[:3, 1]) > 0.95
    return near & same_closing & (tools[:, :3, 2] @ tool[:3, 2] > 0.95)


def _orientations(points: Array, tilts: Iterable[float]) -> Iterator[tuple[Array, float]]:
    """Tool orientations, shape (3, 3), columns across, closing and approach, with their tilt."""
    flat = points[:, :2] - points[:, :2].mean(axis=0)
    lengthwise = np.append(np.linalg.eigh(flat.T @ flat)[1][:, 1], 0.0)
    for tilt in tilts:
        level = tilt > 0.6
        for azimuth in np.arange(8) * (math.pi / 4) if tilt else (0.0,):
            sine = math.sin(tilt)
            approach = np.array(
                [sine * math.cos(azimuth), sine * math.sin(azimuth), -math.cos(tilt)]
            )
            aside = np.cross(approach, [0.0, 1.0, 0.0] if abs(approach[1]) < 0.9 else [1.0, 0, 0])
            aside /= np.linalg.norm(aside)
            other = np.cross(approach, aside)
            along = math.atan2(lengthwise @ other, lengthwise @ aside)
            grid = [k * math.pi / 12 for k in range(12)]
            turns = grid[::3] if level else [*grid, along, along + math.pi / 2]
            for turn in turns:
                across = math.cos(turn) * aside + math.sin(turn) * other
                closing = np.cross(approach, across)
                # A flat approach with one finger above the other would reach under the object.
                if not level or abs(closing[2]) < 0.3:
                    yield np.stack([across, closing, approach], axis=1), tilt


def _grasps_at(
    points: Array, normals: Array, rotation: Array, tilt: float, middle: Array
) -> Iterator[Grasp]:
    """Grasps with one orientation of the tool: a grid over place along the object and depth."""
    local = points @ rotation  # (n, 3): across, closing, approach
    facing = normals @ rotation[:, 1]  # (n,)
    order = np.argsort(local[:, 1])
    local, facing = local[order], facing[order]
    clearance = TABLE_GAP + PAD_HALF_HEIGHT * math.cos(tilt) + 0.01 * math.sin(tilt)
    for place in _places(local[:, 0]):
        near = np.abs(local[:, 0] - place) < PAD_HALF_WIDTH
        slab, slab_facing = local[near], facing[near]
        if len(slab) < FEWEST:
            continue
        depths = slab[:, 2]
        top, bottom = float(depths.min()), float(depths.max())
        for depth in np.arange(top + 0.002, min(top + DEEPEST, bottom + 0.004) + 1e-6, 0.006):
            between = np.abs(depths - depth) < PAD_HALF_HEIGHT
            for squeeze in _squeezes(slab[between], slab_facing[between], place):
                closing = (squeeze.low + squeeze.high) / 2
                centre = rotation @ np.array([place, closing, depth])
                if centre[2] < clearance:
                    continue
                score = _score(squeeze, centre - middle, rotation[:, 2], tilt)
                score += 10 * min(float(depth) - top, 0.02)
                tool = np.eye(4)
                tool[:3, :3], tool[:3, 3] = rotation, centre
                yield Grasp(tool, squeeze.high - squeeze.low, squeeze.quality, score)


def _places(across: Array) -> Array:
    """Places along the object to try, one pad's half-width apart [m]."""
    places = np.arange(across.min() + 0.006, across.max() - 0.003, PAD_HALF_WIDTH)
    return places if len(places) else np.array([across.mean()])


def _squeezes(points: Array, facing: Array, place: float) -> Iterator[_Squeeze]:
    """Each wall between the pads for itself and, where there are several, all of them together.

    Args:
        points: in the tool's orientation, sorted along the closing direction, shape (n, 3) [m].
        facing: the part of their normals in that direction, shape (n,).
        place: of the pads' middle, across [m].
    """
    if len(points) < FEWEST:
        return
    closing = points[:, 1]
    spans = [(0, len(closing))]
    if closing[-1] - closing[0] > GAP:
        cuts = np.flatnonzero(closing[1:] - closing[:-1] > GAP) + 1
        if len(cuts):
            spans = [*pairwise([0, *cuts.tolist(), len(closing)]), *spans]
    for first, last in spans:
        low, high = float(closing[first]), float(closing[last - 1])
        if last - first < 3 or high - low > WIDEST:
            continue
        upper = slice(int(closing.searchsorted(high - SKIN)), last)
        lower = slice(first, int(closing.searchsorted(low + SKIN, "right")))
        quality = _alignment(facing[upper], -facing[lower])
        if quality > LOWEST_QUALITY:
            sideways = abs(_mean(points[upper, 0]) - place) + abs(_mean(points[lower, 0]) - place)
            yield _Squeeze(low, high, quality, sideways, len(spans) > 1)


def _alignment(upper: Array, lower: Array) -> float:
    """How squarely both pads meet the surface: mean and best fifth of the worse side, halves."""
    best = min(float(np.sort(side)[int(0.8 * (len(side) - 1))]) for side in (upper, lower))
    return min(_mean(upper), _mean(lower)) / 2 + best / 2


def _mean(values: Array) -> float:
    # ``ndarray.mean`` costs several times as much on a handful of values.
    return float(np.add.reduce(values)) / len(values)


def _score(squeeze: _Squeeze, offset: Array, approach: Array, tilt: float) -> float:
    """Quality less penalties: off the pads' middle, off the object's middle, tilted, tight, split.

    Found by trying on random scenes; ``offset`` is from the object's middle [m].
    """
    # How deep the grasp sits counts half as much as how far to the side.
    off = offset - approach * (float(offset @ approach) / 2)
    score = (
        2 * squeeze.quality - 30 * squeeze.sideways - 0.35 * tilt - 6 * float(np.linalg.norm(off))
    )
    score -= 0.3 if squeeze.high - squeeze.low > TIGHT else 0.0
    return score - (0.25 if squeeze.split else 0.0)
