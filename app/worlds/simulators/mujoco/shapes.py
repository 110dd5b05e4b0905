"""Triangle meshes made in memory: revolved profiles, swept tubes, prisms, boxes.

All lengths are in [m]. Corners sharper than ``SHARP`` get their own vertices, so that they stay
sharp under smooth shading.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import ConvexHull

Points = NDArray[np.float64]
Profile = Sequence[tuple[float, float]]
"""(radius, z) pairs along a surface of revolution, [m]; the outside is walked upwards."""
SHARP = 0.75
"""Two profile segments that meet at a larger angle than this [rad] form an edge."""


@dataclass(frozen=True, slots=True)
class Mesh:
    """Vertices, shape (n, 3), [m], and faces, shape (m, 3), counter-clockwise from outside."""

    vertices: Points
    faces: NDArray[np.int32]

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> "Mesh":
        """The same, shifted [m]."""
        return Mesh(self.vertices + np.array([x, y, z]), self.faces)

    def turned(self, axis: Literal["x", "y", "z"], angle: float) -> "Mesh":
        """The same, rotated about an axis through the origin by ``angle`` [rad]."""
        first, second = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
        turned = self.vertices.copy()
        turned[:, first] = np.cos(angle) * self.vertices[:, first]
        turned[:, first] -= np.sin(angle) * self.vertices[:, second]
        turned[:, second] = np.sin(angle) * self.vertices[:, first]
        turned[:, second] += np.cos(angle) * self.vertices[:, second]
        return Mesh(turned, self.faces)

    def scaled(self, x: float, y: float, z: float) -> "Mesh":
        """The same, stretched along the axes by positive factors."""
        return Mesh(self.vertices * np.array([x, y, z]), self.faces)

    def bent(self, displace: Callable[[Points], Points]) -> "Mesh":
        """The same, every vertex put where ``displace`` ((n, 3) to (n, 3)) says."""
        return Mesh(displace(self.vertices), self.faces)

    def faceted(self) -> "Mesh":
        """The same, every face with its own vertices, so that it is shaded flat."""
        vertices = self.vertices[self.faces].reshape(-1, 3)
        return Mesh(vertices, np.arange(len(vertices), dtype=np.int32).reshape(-1, 3))

    def fitted(self, size: tuple[float, float, float]) -> "Mesh":
        """The same, stretched to fill a box of this size standing centred on the origin."""
        low, high = self.vertices.min(axis=0), self.vertices.max(axis=0)
        unit = (self.vertices - (low + high) / 2) / (high - low)
        return Mesh(unit * np.array(size) + np.array([0, 0, size[2] / 2]), self.faces)


def merged(*meshes: Mesh) -> Mesh:
    """All of them as one mesh."""
    offsets = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    faces = [mesh.faces + offset for mesh, offset in zip(meshes, offsets, strict=False)]
    return Mesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate(faces).astype(np.int32),
    )


def revolve(profile: Profile, segments: int = 28) -> Mesh:
    """The surface a profile sweeps when it turns about the z axis."""
    return merged(*(_sheet(run, segments) for run in _smooth_runs(np.array(profile, float))))


def _smooth_runs(profile: Points) -> list[Points]:
    """The profile cut at its sharp corners; neighbours share the corner's point."""
    steps = np.diff(profile, axis=0)
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    turn = np.abs((np.diff(heading) + np.pi) % (2 * np.pi) - np.pi)
    corners = [0, *(np.flatnonzero(turn > SHARP) + 1), len(profile) - 1]
    return [profile[a : b + 1] for a, b in pairwise(corners)]


def _sheet(profile: Points, segments: int) -> Mesh:
    angles = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    rings = np.empty((len(profile), segments, 3))
    rings[..., 0] = profile[:, :1] * np.cos(angles)
    rings[..., 1] = profile[:, :1] * np.sin(angles)
    rings[..., 2] = profile[:, 1:]
    return _without_slivers(rings.reshape(-1, 3), _grid(len(profile), segments))


@cache
def _grid(rings: int, segments: int) -> NDArray[np.int32]:
    """Faces between consecutive closed rings of ``segments`` vertices each."""
    ring, column = np.mgrid[0 : rings - 1, 0:segments]
    a = ring * segments + column
    b = ring * segments + (column + 1) % segments
    c, d = b + segments, a + segments
    quads = np.stack([a, b, c, a, c, d], axis=-1)
    return quads.reshape(-1, 3).astype(np.int32)


def _without_slivers(vertices: Points, faces: NDArray[np.int32]) -> Mesh:
    """The mesh without the faces that shrank to a line where a ring closes on the axis."""
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return Mesh(vertices, faces[np.linalg.norm(normals, axis=1) > 1e-12])


def tube(path: ArrayLike, radii: ArrayLike, segments: int = 14) -> Mesh:
    """A tube along a path, shape (n, 3), with a radius per point; closed at both ends."""
    path = np.asarray(path, float)  # (n, 3)
    tangents = np.gradient(path, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    across = np.eye(3)[np.abs(tangents).max(axis=0).argmin()]  # no tangent points that way
    side = np.cross(across, tangents)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    over = np.cross(tangents, side)
    angles = np.linspace(0, 2 * np.pi, segments, endpoint=False)[None, :, None]
    spokes = np.cos(angles) * side[:, None] + np.sin(angles) * over[:, None]  # (n, segments, 3)
    rings = path[:, None] + np.array(radii)[:, None, None] * spokes
    ends = np.stack([np.repeat(path[:1], segments, 0), np.repeat(path[-1:], segments, 0)])
    rings = np.concatenate([ends[:1], rings, ends[1:]])
    return _without_slivers(rings.reshape(-1, 3), _grid(len(rings), segments))


def lying(profile: Profile, segments: int = 24) -> Mesh:
    """A surface of revolution lying along x with its underside straight, a facet down.

    The profile has (radius, x) pairs [m].
    """
    radii, along = np.array(profile, float).T
    body = revolve(profile, segments).turned("y", np.pi / 2).turned("x", np.pi / segments)
    levels, level = np.unique(along, return_inverse=True)
    widest = np.zeros(len(levels))
    np.maximum.at(widest, level, radii * np.cos(np.pi / segments))
    return body.bent(
        lambda points: points + np.outer(np.interp(points[:, 0], levels, widest), (0, 0, 1))
    )


def prism(outline: Sequence[tuple[float, float]], bottom: float, top: float) -> Mesh:
    """An outline, counter-clockwise and visible from its centroid, given a thickness along z."""
    flat = np.array(outline, float)
    count = len(flat)
    centre = flat.mean(axis=0)
    ring = np.column_stack([flat, np.zeros(count)])
    fan = np.array([[count, i, (i + 1) % count] for i in range(count)], np.int32)
    cap = np.vstack([ring, [*centre, 0.0]])
    lift = np.array([0.0, 0.0, 1.0])
    upper, lower = Mesh(cap + top * lift, fan), Mesh(cap + bottom * lift, fan[:, ::-1])
    walls = Mesh(np.vstack([ring + bottom * lift, ring + top * lift]), _grid(2, count))
    return merged(upper, lower, walls.faceted())


def box(
    half: Sequence[float], centre: Sequence[float] | Points = (0, 0, 0), bevel: float = 0.0
) -> Mesh:
    """A box of these half extents; ``bevel`` [m], less than any of them, takes the edges off."""
    signs, kept = _box_corners()
    if bevel == 0.0:
        return Mesh(signs[:8] * np.array(half) + np.array(centre), _box_faces(0)).faceted()
    corners = signs * (np.array(half) - bevel * kept)
    return Mesh(corners + np.array(centre), _box_faces(1)).faceted()


@cache
def _box_corners() -> tuple[Points, Points]:
    """Signs of a bevelled box's corners, shape (24, 3), and along which axes a bevel moves them."""
    signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
    moved = np.repeat(1 - np.eye(3), 8, axis=0)
    return np.tile(signs, (3, 1)).astype(float), moved


@cache
def _box_faces(bevels: int) -> NDArray[np.int32]:
    """Those of the hull of its corners, the same for every box without or with a bevel."""
    signs, moved = _box_corners()
    return hull(signs * (1 - 0.2 * moved) if bevels else signs[:8]).faces


@cache
def _unit_ball(rings: int) -> Mesh:
    around = np.linspace(-np.pi / 2, np.pi / 2, rings)
    return revolve([(float(np.cos(a)), float(np.sin(a))) for a in around], 2 * rings)


def ellipsoid(
    radii: Sequence[float], centre: Sequence[float] | Points = (0, 0, 0), rings: int = 14
) -> Mesh:
    """An ellipsoid with these half axes."""
    return _unit_ball(rings).scaled(*radii).moved(*centre)


def hull(points: Points) -> Mesh:
    """The convex hull of points, shape (n, 3)."""
    convex = ConvexHull(points)
    corners = points[convex.simplices]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", normals, convex.equations[:, :3]) < 0
    faces = convex.simplices.copy()
    faces[inward] = faces[inward][:, ::-1]
    return Mesh(points, faces.astype(np.int32))


def ring_wedges(inner: Profile, outer: Profile, sectors: int = 16) -> list[Points]:
    """Convex pieces of the shell between two profiles of equal length, each a point set (8, 3)."""
    angles = np.linspace(0, 2 * np.pi, sectors + 1)
    pieces: list[Points] = []
    for low in range(len(inner) - 1):
        section = np.array([inner[low], outer[low], inner[low + 1], outer[low + 1]])  # (4, 2)
        for start, end in pairwise(angles):
            corners = [
                (radius * np.cos(angle), radius * np.sin(angle), z)
                for angle in (start, end)
                for radius, z in section
            ]
            pieces.append(np.array(corners))
    return pieces


def globe(width: float, height: float, dimple: float = 0.0, segments: int = 28) -> Mesh:
    """A ball-like fruit standing on z = 0, sunk in by ``dimple`` [m] around both poles."""
    around = np.linspace(-np.pi / 2, np.pi / 2, 19)
    radius = np.abs(np.cos(around)) * width / 2
    radius[[0, -1]] = 0.0
    sunk = np.sign(np.sin(around)) * dimple * np.exp(-((radius / (0.3 * width / 2)) ** 2))
    z = height / 2 * (1 + np.sin(around)) - sunk
    return revolve(list(zip(radius.tolist(), z.tolist(), strict=True)), segments)


def star(points: int, inner: float, outer: float) -> list[tuple[float, float]]:
    """The outline of a star with radii in [m], as ``prism`` takes it."""
    angles = np.arange(2 * points) * np.pi / points
    radii = np.where(np.arange(2 * points) % 2 == 0, outer, inner)
    xs, ys = radii * np.cos(angles), radii * np.sin(angles)
    return list(zip(xs.tolist(), ys.tolist(), strict=True))
