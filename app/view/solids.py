"""What a MuJoCo body looks like: one binary glTF of its visible geoms, in the body's own frame."""

from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

import mujoco
import numpy as np
import trimesh
from mujoco import mjtGeom
from trimesh.visual import TextureVisuals
from trimesh.visual.material import PBRMaterial
from viser.transforms import SE3, SO3

VISIBLE_GROUPS = 3
"""Geoms of groups 0 to 2 are to be seen; collision shapes are in group 3."""
SHARP = 0.5
"""A corner is smooth where its normal differs from the mean by less than this [rad]."""

FINE = 1e-5
"""Corners closer than this are one [m]."""
MANY, DETAIL = 700, 40
"""A mesh of more triangles than this is drawn to a 40th of its size. The arm as its maker drew it
has 130,000 triangles, too many for a browser without a graphics card; so it has 50,000.
"""
LOOKS = 2.0
"""Normals are told apart to one part in so many."""


class Corners(NamedTuple):
    """A surface: corners with a normal each, shape (n, 3) [m], and triangles of them, (m, 3)."""

    points: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray


class Geom(NamedTuple):
    """All that a geom's looks depend on, as bytes: equal geoms are drawn once for all models."""

    kind: int
    size: bytes
    position: bytes
    quaternion: bytes
    colour: tuple[int, ...]
    mesh: tuple[bytes, ...] = ()


def body_glb(model: mujoco.MjModel, body_id: int) -> bytes | None:
    """The body's visible geoms as glTF, or None if it has none."""
    geoms = tuple(_geom(model, geom_id) for geom_id in _visible(model, body_id))
    return _glb(geoms) if geoms else None


def _visible(model: mujoco.MjModel, body_id: int) -> Iterator[int]:
    first = int(model.body_geomadr[body_id])
    for geom_id in range(first, first + int(model.body_geomnum[body_id])):
        endless = model.geom_type[geom_id] == mjtGeom.mjGEOM_PLANE
        if model.geom_group[geom_id] < VISIBLE_GROUPS and not endless and _rgba(model, geom_id)[3]:
            yield geom_id


def _rgba(model: mujoco.MjModel, geom_id: int) -> np.ndarray:
    material = int(model.geom_matid[geom_id])
    return model.mat_rgba[material] if material >= 0 else model.geom_rgba[geom_id]


def _geom(model: mujoco.MjModel, geom_id: int) -> Geom:
    colour = np.clip(_rgba(model, geom_id) * 255, 0, 255).astype(int)
    return Geom(
        int(model.geom_type[geom_id]),
        model.geom_size[geom_id].tobytes(),
        model.geom_pos[geom_id].tobytes(),
        model.geom_quat[geom_id].tobytes(),
        tuple(int(value) for value in colour),
        _mesh(model, int(model.geom_dataid[geom_id])),
    )


def _mesh(model: mujoco.MjModel, mesh_id: int) -> tuple[bytes, ...]:
    if mesh_id < 0:
        return ()
    vertices = slice(model.mesh_vertadr[mesh_id], None)
    normals = slice(model.mesh_normaladr[mesh_id], None)
    faces = slice(model.mesh_faceadr[mesh_id], None)
    return (
        model.mesh_vert[vertices][: model.mesh_vertnum[mesh_id]].tobytes(),
        model.mesh_normal[normals][: model.mesh_normalnum[mesh_id]].tobytes(),
        model.mesh_face[faces][: model.mesh_facenum[mesh_id]].tobytes(),
        model.mesh_facenormal[faces][: model.mesh_facenum[mesh_id]].tobytes(),
    )


@lru_cache(maxsize=512)
def _glb(geoms: tuple[Geom, ...]) -> bytes:
    scene = trimesh.Scene()
    for colour in dict.fromkeys(geom.colour for geom in geoms):
        same = [_placed(geom) for geom in geoms if geom.colour == colour]
        scene.add_geometry(_surface(_joined(same), colour))
    exported = scene.export(file_type="glb")
    assert isinstance(exported, bytes)
    return exported


def _placed(geom: Geom) -> Corners:
    corners = _mesh_corners(geom.mesh) if geom.mesh else _primitive_corners(geom)
    rotation = SO3(np.frombuffer(geom.quaternion))
    placement = SE3.from_rotation_and_translation(rotation, np.frombuffer(geom.position))
    points, normals = placement.apply(corners.points), rotation.apply(corners.normals)
    return Corners(points, normals, corners.triangles)


def _mesh_corners(mesh: tuple[bytes, ...]) -> Corners:
    points = np.frombuffer(mesh[0], np.float32).reshape(-1, 3)
    normals = np.frombuffer(mesh[1], np.float32).reshape(-1, 3)
    point_of, normal_of = (np.frombuffer(part, np.int32) for part in mesh[2:])
    grain = float(np.ptp(points, axis=0).max()) / DETAIL if len(point_of) > 3 * MANY else FINE
    return _welded(points[point_of], _smoothed(points[point_of], normals[normal_of]), grain)


def _primitive_corners(geom: Geom) -> Corners:
    shape = _primitive(geom.kind, np.frombuffer(geom.size))
    points = shape.vertices[shape.faces].reshape(-1, 3)
    return _welded(points, _smoothed(points, np.repeat(shape.face_normals, 3, axis=0)), FINE)


def _primitive(kind: int, size: np.ndarray) -> trimesh.Trimesh:
    match kind:
        case mjtGeom.mjGEOM_BOX:
            return trimesh.creation.box(extents=2 * size)
        case mjtGeom.mjGEOM_CYLINDER:
            return trimesh.creation.cylinder(radius=size[0], height=2 * size[1], sections=48)
        case mjtGeom.mjGEOM_CAPSULE:
            return trimesh.creation.capsule(radius=size[0], height=2 * size[1], count=(24, 24))
        case _:  # a sphere has one radius, an ellipsoid three
            ball = trimesh.creation.icosphere(subdivisions=3)
            return ball.apply_scale(size if kind == mjtGeom.mjGEOM_ELLIPSOID else size[0])


def _smoothed(points: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """The mean normal of all corners at the same point, but at an edge each its own; (n, 3)."""
    _, place = _same(points / FINE)
    smooth = _means(place, normals)[place]
    bent = np.sum(normals * smooth, axis=1) > np.cos(SHARP)
    return np.where(bent[:, None], smooth, normals)


def _welded(points: np.ndarray, normals: np.ndarray, grain: float) -> Corners:
    """One corner for all that lie in the same cell of ``grain`` [m] and look the same way.

    Three a triangle come in; triangles that have shrunk to nothing do not come out.
    """
    first_of_cell, cell = _same(points / grain)
    first, corner = _same(np.column_stack((cell, normals * LOOKS)))
    triangles, cells = corner.reshape(-1, 3), cell.reshape(-1, 3)
    whole = (cells != np.roll(cells, 1, axis=1)).all(axis=1)
    return Corners(points[first_of_cell][cell[first]], _means(corner, normals), triangles[whole])


def _means(kind: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """The mean direction of each kind's normals, (kinds, 3)."""
    total = np.column_stack([np.bincount(kind, normals[:, axis]) for axis in range(3)])
    return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)


def _same(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Which rows are the first of their kind when rounded, and the kind of every row."""
    rounded = np.ascontiguousarray(np.round(rows).astype(np.int32))
    packed = rounded.view(np.dtype((np.void, rounded.itemsize * rounded.shape[1]))).ravel()
    _, first, kind = np.unique(packed, return_index=True, return_inverse=True)
    return first, kind


def _joined(parts: list[Corners]) -> Corners:
    starts = np.cumsum([0, *(len(part.points) for part in parts)])
    return Corners(
        np.vstack([part.points for part in parts]),
        np.vstack([part.normals for part in parts]),
        np.vstack([part.triangles + start for part, start in zip(parts, starts, strict=False)]),
    )


def _surface(corners: Corners, colour: tuple[int, ...]) -> trimesh.Trimesh:
    rgba = np.array(colour) / 255
    material = PBRMaterial(
        baseColorFactor=[*_linear(rgba[:3]), rgba[3]],
        metallicFactor=0.0,
        roughnessFactor=0.65,
        alphaMode="BLEND" if colour[3] < 255 else "OPAQUE",
    )
    return trimesh.Trimesh(
        corners.points.astype(np.float32),
        corners.triangles,
        vertex_normals=corners.normals.astype(np.float32),
        visual=TextureVisuals(material=material),
        process=False,
    )


def _linear(srgb: np.ndarray) -> np.ndarray:
    """Colours as screens take them to light as glTF wants it, both in [0, 1]; IEC 61966-2-1."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
