"""Depth cameras made of rays: labelled point clouds of the objects, without a display."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from app.domain.perception import Perception
from app.worlds.simulators.mujoco.camera import CAMERAS, LOW_CAMERAS, Camera
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.depth import DepthImage
from app.worlds.simulators.mujoco.detector import Confused, Detector, Segmentation
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.raycast import cast
from app.worlds.simulators.mujoco.silhouettes import Silhouettes, pixels_of

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

GROUPS = np.array([1, 0, 0, 1, 0, 0], np.uint8)
"""The geometry groups that are seen: plain geoms and collision geoms, not the visual copies."""
OVERVIEW = (160, 120)
CLOSE_UP = (80, 80)
"""Width and height of the images in pixels."""
GLIMPSE = (20, 20)
MARGIN = 0.02
"""How far around an object a close-up reaches, since the overview sees it coarsely [m]."""
FEWEST = 3
"""An object seen by fewer pixels counts as not seen."""
SEARCHED = 0.10
"""So far around the tool, what is not seen otherwise is looked for [m]."""
PARTS = tuple((0.42, y, 0.02) for y in (-0.45, -0.15, 0.15, 0.45))
PART = 0.25
"""Middles of the parts into which the table is divided for that, and their radius [m]."""
COVERED = 0.015
"""By so much, coarse clouds of one object may differ in extent [m]."""
LIFTED = 0.05
"""What is all above this height is looked at from below as well [m]."""
_NEIGHBOURHOODS = {OVERVIEW: 1, CLOSE_UP: 2, GLIMPSE: 1}
"""How many pixels to each side go into a measured surface."""


@dataclass(frozen=True, slots=True)
class _Hits:
    """What an image's rays hit; where none was cast, label -1."""

    labels: NDArray[np.int32]
    depths: Array
    normals: Array
    """Base frame, shape (height, width, 3)."""


class Cameras:
    """The cameras around the table; what they see is labelled with the objects' names."""

    def __init__(
        self,
        physics: Physics,
        perception: Perception | None = None,
        seed: int = 0,
        detector: Detector | None = None,
    ) -> None:
        """Put them up.

        Args:
            physics: what they look at.
            perception: how well they see; None for privileged cameras, without any noise.
            seed: of the noise and of confusions.
            detector: who tells the objects apart; None for the simulator's segmentation.
        """
        self._physics = physics
        self._seed = seed
        self._names = tuple(physics.bodies)
        perception = perception or Perception(source="privileged")
        self._noise = perception.noise if perception.source == "cameras" else 0.0
        self._detector = self._detecting(detector, perception.confusion)
        parts = [part for body in physics.bodies.values() for part in body.parts]
        self._silhouettes = Silhouettes(physics.model, parts, GROUPS)
        self._seen: dict[str, Cloud] = {}
        self._earlier: dict[str, Cloud] = {}
        """Where each object was last seen during the action under way."""
        self._close: set[str] = set()
        self._moment, self._woken = (-1, b""), -1

    def look(self, *names: str) -> dict[str, Cloud]:
        """Clouds of what is seen, the named ones and what is next to them from close up."""
        if self._moment != self._now() or self._woken != self._physics.woken:
            kept = self._earlier | self._seen if self._woken == self._physics.woken else {}
            self._moment, self._woken, self._earlier = self._now(), self._physics.woken, kept
            self._seen, self._close = self.overview(), set[str]()
        for name in names:
            if name not in self._seen:
                self._search(name)
            if name not in self._seen or name in self._close:
                continue
            self._close.add(name)
            for other, cloud in self.close_up(self._seen[name]).items():
                known = self._seen.get(other, cloud)
                # At the edge of a close-up, only a part of a neighbour may be in view.
                if other == name or _covers(cloud, known):
                    self._seen[other] = max(cloud, known, key=len)
        return dict(self._seen)

    def _search(self, name: str) -> None:
        """Look for what is too thin for the overview: in the gripper, where it was, all over."""
        arm, joints = self._physics.arm, self._physics.joints
        balls = [(arm.forward(joints)[:3, 3], SEARCHED)]
        if name in self._earlier:
            balls.append(_ball(self._earlier[name]))
        balls += [(np.array(part), PART) for part in PARTS]
        for centre, radius in balls:
            found = self._everything(centre, radius, CLOSE_UP)
            if name in found:
                self._seen[name] = found[name]
                return

    def overview(self) -> dict[str, Cloud]:
        """A coarse cloud of every object that is seen."""
        return self._shown(CAMERAS, OVERVIEW)

    def close_up(self, cloud: Cloud) -> dict[str, Cloud]:
        """Fine clouds of what is at the place of ``cloud``, from every camera."""
        centre, radius = _ball(cloud)
        lifted = cloud.lowest[2] > LIFTED
        cameras = (*CAMERAS, *LOW_CAMERAS) if lifted else CAMERAS
        zoomed = [camera.zoomed(centre, radius) for camera in cameras]
        return self._shown(zoomed, CLOSE_UP, lambda view: _around(view, cloud.points, radius))

    def glimpse(self, centre: Array, radius: float) -> dict[str, Cloud]:
        """What there is in a ball, shape (3,) [m], at little cost: few pixels, too few for shapes."""
        return self._everything(centre, radius, GLIMPSE)

    def _everything(self, centre: Array, radius: float, size: tuple[int, int]) -> dict[str, Cloud]:
        """What images of a ball show, each of so many columns and rows."""
        return self._shown([camera.zoomed(centre, radius) for camera in CAMERAS], size)

    def _shown(
        self,
        cameras: Iterable[Camera],
        size: tuple[int, int],
        within: Callable[[Camera], Mask] | None = None,
    ) -> dict[str, Cloud]:
        """What these cameras' images show, or only the part of each ``within`` a mask."""
        data = self._physics.stand()
        corners = self._silhouettes.corners(data)
        images = list[tuple[Camera, _Hits]]()
        for camera in cameras:
            mask = pixels_of(corners, camera, size)
            if within is not None:
                mask &= within(camera)
            images.append((camera, self._cast(data, camera, mask)))
        return self._clouds(images)

    def current(self) -> dict[str, Cloud]:
        """What the last look showed, if nothing has moved since; else another look."""
        return self.look()

    def latest(self) -> dict[str, Cloud]:
        """What the last look of the same action showed, whatever has moved since; else a look."""
        return dict(self._seen) if self._woken == self._physics.woken else self.look()

    def _now(self) -> tuple[int, bytes]:
        # Not the time alone: another state may have been restored.
        return self._physics.steps, self._physics.data.qpos.tobytes()

    def _detecting(self, detector: Detector | None, confusion: float) -> Detector:
        objects = [body.parts for body in self._physics.bodies.values()]
        telling = detector or Segmentation(objects, self._physics.model.nbody)
        if confusion == 0:
            return telling
        return Confused(telling, len(objects), confusion, self._seed)

    def _cast(self, data: mujoco.MjData, camera: Camera, mask: Mask) -> _Hits:
        """An image of the pixels of a mask, shape (height, width)."""
        height, width = mask.shape
        hits = _Hits(
            np.full(mask.shape, -1, np.int32), np.zeros(mask.shape), np.zeros((*mask.shape, 3))
        )
        rows, columns = np.nonzero(mask)
        if len(rows) == 0:
            return hits
        met = cast(self._physics.model, data, camera, (width, height), (rows, columns), GROUPS)
        # The last geom's body stands for index -1, a ray that hit nothing; it is put right below.
        bodies = self._physics.model.geom_bodyid[met.geoms]
        labels = self._detector.label(bodies, met.points)
        hits.labels[rows, columns] = np.where(met.geoms >= 0, labels, -1)
        hits.depths[rows, columns] = met.depths
        hits.normals[rows, columns] = met.normals
        return hits

    def _clouds(self, images: Iterable[tuple[Camera, _Hits]]) -> dict[str, Cloud]:
        # The same moment shows the same picture, whatever was looked at before.
        rng = np.random.default_rng((self._seed, self._physics.steps))
        pieces: dict[str, list[Cloud]] = {}
        for camera, hits in images:
            labels, cloud = self._surface(camera, hits, rng)
            for label in np.unique(labels).tolist():
                own = labels == label
                piece = Cloud(cloud.points[own], cloud.normals[own])
                pieces.setdefault(self._names[label], []).append(piece)
        joined = {name: Cloud.joined(pieces[name]) for name in self._names if name in pieces}
        return {name: cloud for name, cloud in joined.items() if len(cloud) >= FEWEST}

    def _surface(
        self, camera: Camera, hits: _Hits, rng: np.random.Generator
    ) -> tuple[NDArray[np.int32], Cloud]:
        """Labels (n,) and surface, base frame, of the pixels that show an object."""
        height, width = hits.labels.shape
        a, b = camera.tangents(width, height)
        axes, position = camera.axes(), np.array(camera.position)
        if self._noise:
            image = DepthImage(hits.labels, hits.depths, (a, b)).with_noise(self._noise, rng)
            labels, points, normals = image.surfaces(_NEIGHBOURHOODS[width, height])
            return labels, Cloud(position + points @ axes, normals @ axes)
        rows, columns = np.nonzero(hits.labels >= 0)
        depths = hits.depths[rows, columns]
        points = np.stack([a[columns] * depths, b[rows] * depths, depths], axis=1)
        cloud = Cloud(position + points @ axes, hits.normals[rows, columns])
        return hits.labels[rows, columns], cloud


def _covers(cloud: Cloud, other: Cloud) -> bool:
    """Whether a cloud reaches about as far as another of the same object."""
    low = cloud.lowest < other.lowest + COVERED
    return bool((low & (cloud.highest > other.highest - COVERED)).all())


def _ball(cloud: Cloud) -> tuple[Array, float]:
    """The middle of a cloud, shape (3,), and how far around it a close-up reaches [m]."""
    centre = (cloud.lowest + cloud.highest) / 2
    return centre, float(np.linalg.norm(cloud.points - centre, axis=1).max()) + MARGIN


def _around(camera: Camera, points: Array, radius: float) -> Mask:
    """The pixels of a close-up that are next to one of the points, shape (height, width)."""
    width, height = CLOSE_UP
    local = (points - camera.position) @ camera.axes().T
    half = math.tan(camera.field_of_view / 2)
    flat = local[:, :2] / (local[:, 2:] * half)  # -1 to 1 in the image
    columns = np.round((flat[:, 0] + 1) / 2 * (width - 1)).astype(int)
    rows = np.round((1 - flat[:, 1]) / 2 * (height - 1)).astype(int)
    inside = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
    mask = np.zeros((height, width), bool)
    mask[rows[inside], columns[inside]] = True
    reach = math.ceil(MARGIN / 2 / (2 * radius / width))
    return np.asarray(ndimage.maximum_filter(mask, 2 * reach + 1), bool)
