"""Depth cameras made of rays: labelled point clouds of the objects, without a display."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.physics import Physics

Array = NDArray[np.float64]

GROUPS = np.array([1, 0, 0, 1, 0, 0], np.uint8)
"""The geometry groups that are seen: plain geoms and collision geoms, not the visual copies."""
FARTHEST = 5.0
"""Nothing beyond this distance is seen [m]."""
MARGIN = 0.025
"""How far around an object a close-up reaches, since the overview sees it coarsely [m]."""
FEWEST = 3
"""An object seen by fewer rays of the overview counts as not seen."""


@dataclass(frozen=True, slots=True)
class Camera:
    """Where a camera is, what it looks at [m, base frame], and its vertical field of view [rad]."""

    position: tuple[float, float, float]
    target: tuple[float, float, float]
    field_of_view: float = math.radians(60)

    def rays(self, width: int, height: int) -> Array:
        """Unit directions in the base frame, one per pixel, shape (width * height, 3)."""
        forward = np.subtract(self.target, self.position)
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        half = math.tan(self.field_of_view / 2)
        rows = np.linspace(half, -half, height)
        columns = np.linspace(-half, half, width) * (width / height)
        up, across = np.meshgrid(rows, columns, indexing="ij")
        directions = forward + across[..., None] * right + up[..., None] * np.cross(right, forward)
        directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
        return directions.reshape(-1, 3)


CAMERAS = (
    Camera((0.95, -0.55, 0.65), (0.5, 0.0, 0.02)),
    Camera((0.95, 0.55, 0.65), (0.5, 0.0, 0.02)),
    Camera((0.35, 0.0, 1.1), (0.5, 0.0, 0.0)),
    Camera((0.05, -0.55, 0.6), (0.5, 0.0, 0.0)),
)
"""Two in front, one above, one over the robot's right shoulder."""


@dataclass(frozen=True, slots=True)
class Cloud:
    """What was seen of one object: points [m] and outward unit normals, both (n, 3), base frame."""

    points: Array
    normals: Array

    def __len__(self) -> int:
        return len(self.points)

    @property
    def lowest(self) -> Array:
        """The bounding box's lower corner, shape (3,) [m]."""
        return self.points.min(axis=0)

    @property
    def highest(self) -> Array:
        """The bounding box's upper corner, shape (3,) [m]."""
        return self.points.max(axis=0)


class Cameras:
    """The cameras around the table; what they see is labelled with the objects' names."""

    def __init__(self, physics: Physics) -> None:
        self._physics = physics
        self._names: dict[int, str] = {b.body_id: name for name, b in physics.bodies.items()}

    def overview(self, width: int = 80, height: int = 60) -> dict[str, Cloud]:
        """A coarse cloud of every object that is seen."""
        return self._see(CAMERAS, width, height)

    def close_up(self, cloud: Cloud, pixels: int = 90) -> dict[str, Cloud]:
        """Fine clouds of what is at the place of ``cloud``, from every camera."""
        centre = (cloud.lowest + cloud.highest) / 2
        radius = float(np.linalg.norm(cloud.points - centre, axis=1).max()) + MARGIN
        return self._see([_zoomed(camera, centre, radius) for camera in CAMERAS], pixels, pixels)

    def _see(self, cameras: Iterable[Camera], width: int, height: int) -> dict[str, Cloud]:
        data = self._physics.stand()
        pieces: dict[str, list[Cloud]] = {}
        for camera in cameras:
            bodies, cloud = self._cast(data, camera, camera.rays(width, height))
            for body in np.unique(bodies):
                if name := self._names.get(int(body)):
                    seen = bodies == body
                    piece = Cloud(cloud.points[seen], cloud.normals[seen])
                    pieces.setdefault(name, []).append(piece)
        joined = {
            name: Cloud(
                np.concatenate([part.points for part in parts]),
                np.concatenate([part.normals for part in parts]),
            )
            for name, parts in pieces.items()
        }
        return {name: cloud for name, cloud in joined.items() if len(cloud) >= FEWEST}

    def _cast(
        self, data: mujoco.MjData, camera: Camera, rays: Array
    ) -> tuple[NDArray[np.int32], Cloud]:
        count = len(rays)
        geoms = np.zeros(count, np.int32)
        distances = np.zeros(count)
        normals = np.zeros(3 * count)
        origin = np.array(camera.position)
        mujoco.mj_multiRay(
            self._physics.model, data, origin, rays.reshape(-1), GROUPS, True, -1,
            geoms, distances, normals, count, FARTHEST,
        )  # fmt: skip
        hit = geoms >= 0
        rays, normals = rays[hit], normals.reshape(-1, 3)[hit]
        # A hollow body is seen from inside as well: a normal always faces the camera.
        normals *= -np.sign((normals * rays).sum(axis=1, keepdims=True))
        bodies = self._physics.model.geom_bodyid[geoms[hit]]
        return bodies, Cloud(origin + rays * distances[hit, None], normals)


def _zoomed(camera: Camera, centre: Array, radius: float) -> Camera:
    """The same camera, turned and zoomed onto a ball [m]."""
    distance = float(np.linalg.norm(centre - camera.position))
    angle = 2 * math.asin(min(0.9, radius / distance))
    return Camera(camera.position, (centre[0], centre[1], centre[2]), angle)
