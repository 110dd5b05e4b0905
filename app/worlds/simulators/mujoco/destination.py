"""Destination: where in a container, or on top of an object, there is room for another."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cameras import Cloud
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.relations import UPRIGHT
from app.worlds.simulators.mujoco.relief import CELL, Relief, Spot
from app.worlds.simulators.mujoco.scene_builder import ObjectBody

Array = NDArray[np.float64]

AROUND = 0.08
"""How far around the destination heights are mapped, for what overhangs it [m]."""
EDGE = 0.015
"""An object's centre is kept so far inside the opening's edge, where it is wide enough [m]."""
SMALLEST_TOP = 0.0012
"""A level top of a smaller area is not flat enough to put something on [m²]."""
HEAP, FLAT_HEAP = 0.015, 0.06
"""Where an object could only lie so far above the rim, there is no room: in a deep container, and
on a flat one [m]."""
SPOTS_EACH = 4
"""So many spots are considered for each turn of the object."""


@dataclass(frozen=True, slots=True)
class Landing:
    """One way to put an object down."""

    turn: float
    """About the vertical, from how it is now [rad]."""
    spot: Spot


class Destination:
    """The free room of one object as the cameras see it."""

    def __init__(
        self, physics: Physics, body: ObjectBody, clouds: Mapping[str, Cloud], moved: str
    ) -> None:
        """Map it.

        Args:
            physics: where the pose of a container is read from.
            body: the container, or what something is to be put on top of.
            clouds: everything seen, by name.
            moved: the object to be put there; it is no obstacle to itself.

        Raises:
            ActionFailure: nothing can be put there.
        """
        self._body = body
        self._heap = HEAP if body.opening is None or not body.opening.flat else FLAT_HEAP
        cloud = clouds[body.name]
        self.centre = (cloud.lowest[:2] + cloud.highest[:2]) / 2
        half = float((cloud.highest[:2] - cloud.lowest[:2]).max()) / 2 + AROUND
        others = [seen for name, seen in clouds.items() if name != moved]
        self.relief = Relief(others, self.centre, half)
        if body.opening is None:
            self._take_top(cloud)
        else:
            self._take_opening(physics)

    def landings(self, points: Array, middle: Array, turns: Array) -> list[Landing]:
        """Ways to put an object down, the best first.

        Args:
            points: the object's surface as it is now, shape (n, 3) [m].
            middle: what of it is put over a spot, shape (2,) [m].
            turns: how it may be turned about the vertical [rad].

        Raises:
            ActionFailure: it is too large, or there is no room left.
        """
        found: list[Landing] = []
        relative = points - np.append(middle, points[:, 2].min())
        for turn in turns.tolist():
            cosine, sine = np.cos(turn), np.sin(turn)
            under = relative.copy()
            under[:, :2] = relative[:, :2] @ np.array([[cosine, sine], [-sine, cosine]])
            spots = self.relief.spots(under, self.centre)[:SPOTS_EACH]
            found += [Landing(turn, spot) for spot in spots]
        if not found or min(landing.spot.height for landing in found) > self.rim + self._heap:
            raise ActionFailure("place", f"there is no room left in {self._body.name}")
        return sorted(found, key=lambda landing: landing.spot.cost)

    def _take_opening(self, physics: Physics) -> None:
        opening = self._body.opening
        assert opening is not None
        data = physics.stand()
        position = data.xpos[self._body.body_id]
        rotation = data.xmat[self._body.body_id].reshape(3, 3)
        if rotation[2, 2] < UPRIGHT:
            raise ActionFailure("place", f"{self._body.name} has been tipped over")
        self.rim = float(position[2]) + opening.rim
        self.centre = position[:2].copy()
        local = (self.relief.places - self.centre) @ rotation[:2, :2]
        half = np.array(opening.half_extents)
        half = np.maximum(half - EDGE, half / 2)
        if opening.shape == "round":
            inside = np.hypot(*np.moveaxis(local / half, -1, 0)) < 1.0
        else:
            inside = (np.abs(local) < half).all(axis=-1)
        self.relief.allow(inside)

    def _take_top(self, cloud: Cloud) -> None:
        self.rim = float(cloud.highest[2])
        level = self.relief.top_level(cloud)
        if level.sum() * CELL**2 < SMALLEST_TOP:
            reason = f"the top of {self._body.name} is not flat enough to put something on it"
            raise ActionFailure("place", reason)
        self.relief.allow(level)
        self.centre = self.relief.places[level].mean(axis=0)
