"""Destination: where in a container, or on top of an object, there is room for another."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.outline import Outline, Outlines
from app.worlds.simulators.mujoco.relief import CELL, SUNK, Relief, Spot
from app.worlds.simulators.mujoco.rotation import about
from app.worlds.simulators.mujoco.scene_builder import ObjectBody

Array = NDArray[np.float64]

AROUND = 0.08
"""How far around the destination heights are mapped, for what overhangs it [m]."""
SMALLEST_TOP = 0.0012
"""A level top of a smaller area is not flat enough to put something on [m²]."""
HEAP, FLAT_HEAP = 0.015, 0.06
"""Where an object could only lie so far above the rim, there is no room: in a deep container, and
on a flat one [m]."""
SPOTS_EACH = 4
"""So many spots are considered for each turn of the object."""
LEANS = np.radians([15, -15, 25, -25, 35, -35])
"""How far either end of what is too long to lie in a container may be let down first [rad]."""
LEAN_COST = 0.1
"""What leaning costs, in metres of height [m/rad]."""


@dataclass(frozen=True, slots=True)
class Landing:
    """One way to put an object down."""

    turn: float
    """About the vertical, from how it is now [rad]."""
    spot: Spot
    lean: Array = field(default_factory=lambda: np.eye(3))
    """How it is tilted before it is turned, a rotation, shape (3, 3)."""
    sunk: float = 0.0
    """How far tilting brings its lowest point below where it was [m]."""


class Destination:
    """The free room of one object as the cameras see it."""

    def __init__(
        self, outlines: Outlines, body: ObjectBody, clouds: Mapping[str, Cloud], moved: str
    ) -> None:
        """Map it.

        Args:
            outlines: where containers are open.
            body: the container, or what something is to be put on top of.
            clouds: everything seen, by name.
            moved: the object to be put there; it is no obstacle to itself.

        Raises:
            ActionFailure: nothing can be put there.
        """
        self._body = body
        flat = body.opening is not None and body.opening.flat
        self._heap = FLAT_HEAP if flat else HEAP
        cloud = clouds[body.name]
        self.centre = (cloud.lowest[:2] + cloud.highest[:2]) / 2
        half = float((cloud.highest[:2] - cloud.lowest[:2]).max()) / 2 + AROUND
        others = [seen for name, seen in clouds.items() if name != moved]
        self.relief = Relief(others, self.centre, half)
        self._across = np.inf
        if body.opening is None:
            self._take_top(cloud)
        else:
            self._take_opening(outlines.of(body, clouds))
            self._across = np.inf if flat else self.rim

    def landings(self, points: Array, middle: Array, turns: Array) -> list[Landing]:
        """Ways to put an object down, the best first.

        Args:
            points: the object's surface as it is now, shape (n, 3) [m].
            middle: what of it is put over a spot, shape (2,) [m].
            turns: how it may be turned about the vertical [rad].

        Raises:
            ActionFailure: it is too large, or there is no room left.
        """
        relative = points - np.append(middle, points[:, 2].min())
        found = self._found(relative, turns)
        if not found or _lowest(found) > self._across - SUNK:
            # Lying, it would stay on the rim: one end goes down inside.
            found += self._leaning(relative, turns)
        if not found or _lowest(found) > self.rim + self._heap:
            raise ActionFailure("place", f"there is no room left in {self._body.name}")
        return sorted(found, key=lambda landing: landing.spot.cost)

    def _found(self, relative: Array, turns: Array) -> list[Landing]:
        found: list[Landing] = []
        for turn in turns.tolist():
            cosine, sine = np.cos(turn), np.sin(turn)
            under = relative.copy()
            under[:, :2] = relative[:, :2] @ np.array([[cosine, sine], [-sine, cosine]])
            spots = self.relief.spots(under, self.centre, self._across)[:SPOTS_EACH]
            found += [Landing(turn, spot) for spot in spots]
        return found

    def _leaning(self, relative: Array, turns: Array) -> list[Landing]:
        found: list[Landing] = []
        for angle in LEANS.tolist():
            lean = about(_crosswise(relative), angle)
            leant = relative @ lean.T
            sunk = -float(leant[:, 2].min())
            dear = LEAN_COST * abs(angle)
            found += [
                replace(
                    landing,
                    spot=replace(landing.spot, cost=landing.spot.cost + dear),
                    lean=lean,
                    sunk=sunk,
                )
                for landing in self._found(leant + np.array([0.0, 0.0, sunk]), turns)
            ]
        return found

    def _take_opening(self, outline: Outline) -> None:
        self.rim, self.centre = outline.rim, outline.centre
        self.relief.allow(outline.roomy(self.relief.places))

    def _take_top(self, cloud: Cloud) -> None:
        self.rim = float(cloud.highest[2])
        level = self.relief.top_level(cloud)
        if level.sum() * CELL**2 < SMALLEST_TOP:
            reason = f"the top of {self._body.name} is not flat enough to put something on it"
            raise ActionFailure("place", reason)
        self.relief.allow(level)
        self.centre = self.relief.places[level].mean(axis=0)


def _lowest(landings: list[Landing]) -> float:
    return min(landing.spot.height for landing in landings)


def _crosswise(points: Array) -> Array:
    """The level direction across what is long, of points (n, 3); shape (3,)."""
    flat = points[:, :2] - points[:, :2].mean(axis=0)
    return np.append(np.linalg.eigh(flat.T @ flat)[1][:, 0], 0.0)
