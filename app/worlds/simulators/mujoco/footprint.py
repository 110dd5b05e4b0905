"""Footprint: the area an object takes on the table, and how far two of them are apart."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Footprint:
    """Rectangles (a round one: points) of half extents (n, 2) [m], grown by a radius (n,) [m].

    They stand at centres (n, 2) [m], turned by yaw (n,) [rad].
    """

    centre: Array
    yaw: Array
    half: Array
    radius: Array

    @classmethod
    def none(cls) -> "Footprint":
        """No footprint at all."""
        return cls(
            centre=np.empty((0, 2)), yaw=np.empty(0), half=np.empty((0, 2)), radius=np.empty(0)
        )

    def __len__(self) -> int:
        return len(self.yaw)

    def __getitem__(self, index: int | NDArray[np.intp]) -> "Footprint":
        part = np.atleast_1d(index)
        return Footprint(
            centre=self.centre[part],
            yaw=self.yaw[part],
            half=self.half[part],
            radius=self.radius[part],
        )

    def joined(self, other: "Footprint") -> "Footprint":
        """These and those."""
        return Footprint(
            centre=np.concatenate([self.centre, other.centre]),
            yaw=np.concatenate([self.yaw, other.yaw]),
            half=np.concatenate([self.half, other.half]),
            radius=np.concatenate([self.radius, other.radius]),
        )


def gaps(ours: Footprint, theirs: Footprint) -> Array:
    """How far each of ours (n) is from each of theirs (m), shape (n, m), [m]; overlap is negative.

    The separating-axis distance over both pairs of edges and the line between the centres: exact
    for discs and for facing edges, else at most the true distance.
    """
    apart = theirs.centre[None] - ours.centre[:, None]  # (n, m, 2)
    distance = np.hypot(apart[..., 0], apart[..., 1])
    bearing = np.arctan2(apart[..., 1], apart[..., 0])
    along = [bearing]
    along += [np.broadcast_to(ours.yaw[:, None] + turn, bearing.shape) for turn in (0, np.pi / 2)]
    along += [np.broadcast_to(theirs.yaw[None] + turn, bearing.shape) for turn in (0, np.pi / 2)]
    axes = np.stack(along)  # (5, n, m), directions [rad]
    clear = distance * np.abs(np.cos(bearing - axes))
    clear -= _support(ours.half[:, None], axes - ours.yaw[:, None])
    clear -= _support(theirs.half[None], axes - theirs.yaw[None])
    return clear.max(axis=0) - ours.radius[:, None] - theirs.radius[None]


def first_free(
    ours: Footprint, theirs: Footprint, beside: Array, *, closest: bool = False
) -> int | None:
    """The first of ours that leaves so much room beside each of theirs, or None.

    Args:
        ours: places to choose from, all of one shape.
        theirs: what stands already, m of them.
        beside: the room to leave, shape (m,) [m].
        closest: rather the one that leaves the least of what it may.
    """
    if len(theirs) == 0:
        return 0
    apart = np.hypot(*(theirs.centre[None] - ours.centre[:, None]).transpose(2, 0, 1)) - beside
    outer = apart - _reach(ours, np.linalg.norm)[:, None] - _reach(theirs, np.linalg.norm)
    if not closest and len(sure := np.flatnonzero((outer >= 0).all(axis=1))):
        return int(sure[0])
    inner = apart - _reach(ours, np.min)[:, None] - _reach(theirs, np.min)
    possible = np.flatnonzero((inner >= 0).all(axis=1))
    if len(possible) == 0:
        return None
    spare = (gaps(ours[possible], theirs) - beside).min(axis=1)
    free = np.flatnonzero(spare >= 0)
    if len(free) == 0:
        return None
    return int(possible[free[spare[free].argmin()] if closest else free[0]])


def _reach(footprint: Footprint, of: Callable[..., Array]) -> Array:
    """From the centres to the farthest points (``of`` the norm) or the nearest edges (the least)."""
    return of(footprint.half, axis=1) + footprint.radius


def _support(half: Array, direction: Array) -> Array:
    """Half the width of rectangles (…, 2) seen along directions in their own frames [m]."""
    return half[..., 0] * np.abs(np.cos(direction)) + half[..., 1] * np.abs(np.sin(direction))
