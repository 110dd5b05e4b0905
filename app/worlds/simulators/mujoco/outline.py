"""Outline: the inside of a container's rim, as it is known or as it is seen."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.relations import UPRIGHT
from app.worlds.simulators.mujoco.scene_builder import ObjectBody

Array = NDArray[np.float64]

EDGE = 0.015
"""An object's centre is kept so far inside the opening's edge, where it is wide enough [m]."""
WALL = 0.005
"""What is seen of a rim is its outside; so much farther in is its inside [m]."""
RIM = 0.25
"""So much of a container's height, from the top, counts as its rim."""
HOLLOW, LOW = 0.15, 0.1
"""A container is hollow if so much of what shows inside (``LOW``) lies lower than the rim by so much
of its height; contents hide most of a floor."""
FLATTEST = 0.05
"""A plate or a tray that stands higher does not lie as it should [m]."""
FEWEST = 8
"""From fewer points no outline is made."""


@dataclass(frozen=True, slots=True)
class Outline:
    """A convex area that is open from above."""

    centre: Array
    """Shape (2,), base frame [m]."""
    rim: float
    """Height of the upper edge above the table [m]."""
    edges: Array
    """Outward unit normals and offsets (a, b, c) of half planes a x + b y + c <= 0, shape (n, 3)."""

    def inset(self, places: Array) -> Array:
        """How far places, shape (…, 2), are inside of the edge, shape (…) [m]."""
        return -(places @ self.edges[:, :2].T + self.edges[:, 2]).max(axis=-1)

    def roomy(self, places: Array) -> NDArray[np.bool_]:
        """Which places, shape (…, 2), are far enough inside for an object's centre."""
        deepest = float(self.inset(self.centre))
        return self.inset(places) > min(EDGE, deepest / 2)


class Outlines(Protocol):
    """Where containers are open."""

    def of(self, body: ObjectBody, clouds: Mapping[str, Cloud]) -> Outline:
        """The outline of a container.

        Args:
            body: which; what is used of it depends on who answers.
            clouds: everything that was seen.

        Raises:
            ActionFailure: it has been tipped over, or it is not seen.
        """
        ...


class KnownOutlines:
    """Read from the simulator."""

    def __init__(self, physics: Physics) -> None:
        self._physics = physics

    def of(self, body: ObjectBody, clouds: Mapping[str, Cloud]) -> Outline:
        """The outline of a container; see ``Outlines``."""
        del clouds  # Unused: the simulator knows.
        opening = body.opening
        assert opening is not None
        data = self._physics.stand()
        position = data.xpos[body.cavity]
        rotation = data.xmat[body.cavity].reshape(3, 3)
        if rotation[2, 2] < UPRIGHT:
            raise _tipped(body.name)
        half = np.array(opening.half_extents)
        count = 4 if opening.shape == "box" else 32
        turn = np.arange(count) * (2 * np.pi / count)
        normals = np.column_stack([np.cos(turn), np.sin(turn)])
        reach = np.abs(normals * half).sum(axis=1) if count == 4 else np.full(count, half.min())
        normals = normals @ rotation[:2, :2].T
        offsets = -(normals @ position[:2]) - reach
        edges = np.column_stack([normals, offsets])
        return Outline(position[:2].copy(), float(position[2]) + opening.rim, edges)


class SeenOutlines:
    """Made of what the cameras see of a container's rim.

    Of the catalogue it takes only that the object is a container, and whether it is a flat one.
    """

    def of(self, body: ObjectBody, clouds: Mapping[str, Cloud]) -> Outline:
        """The outline of a container; see ``Outlines``."""
        if body.name not in clouds:
            raise ActionFailure(
                "look", f"{body.name} is hidden or has fallen off the table: no camera sees it"
            )
        points = clouds[body.name].points
        rim, floor = (float(level) for level in np.quantile(points[:, 2], (0.98, 0.0)))
        height = rim - floor
        edge = points[points[:, 2] > rim - max(0.004, RIM * height), :2]
        edges = hull(edge)
        if edges is None:
            raise _tipped(body.name)
        edges = edges + np.array([0.0, 0.0, WALL])
        corner = (edge.min(axis=0) + edge.max(axis=0)) / 2
        outline = Outline(corner, rim, edges)
        inner = points[outline.roomy(points[:, :2]), 2]
        flat = body.opening is not None and body.opening.flat
        hollow = len(inner) < FEWEST or float(np.quantile(inner, LOW)) < rim - HOLLOW * height
        if (flat and height > FLATTEST) or not hollow:
            raise _tipped(body.name)
        return outline


def hull(points: Array) -> Array | None:
    """Half planes around points (n, 2), shape (k, 3); None where they enclose no area."""
    if len(points) < FEWEST:
        return None
    try:
        return np.asarray(ConvexHull(points).equations, float)
    except QhullError:
        return None


def _tipped(name: str) -> ActionFailure:
    return ActionFailure("place", f"{name} has been tipped over")
