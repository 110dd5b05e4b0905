"""RigidBody: what a compiled model of one body is as an object: what is seen of it, what collides."""

from dataclasses import dataclass

import mujoco
import numpy as np
import trimesh
from mujoco import mjtGeom
from numpy.typing import NDArray

from app.domain.errors import AssetRefused, Fault
from app.worlds.simulators.mujoco.convex_parts import convex_parts, hull_of
from app.worlds.simulators.mujoco.shapes import Mesh, Points
from app.worlds.simulators.mujoco.solid_shape import Look, Primitive, Shape
from app.worlds.simulators.mujoco.uploaded_mesh import MAX_FACES, size_fault

Array = NDArray[np.float64]

DENSITIES = (20.0, 20_000.0)
"""From a foam to a metal [kg/m³]."""
ONE_RIGID = "an object is one rigid body, at most on a free joint"
UNNAMED = (0.5, 0.5, 0.5, 1.0)
"""The colour MuJoCo gives what has none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RigidBody:
    """What was read."""

    shape: Shape
    size: tuple[float, float, float]
    """Length, width, height of the bounding box [m]."""
    volume: float
    """Of what collides [m³]."""
    mass: float
    """[kg]"""
    faces: int
    """Triangles that are seen."""


def rigid_body(model: mujoco.MjModel, *, hulls: bool) -> RigidBody:
    """The body of a model, standing on z = 0, the middle of its footprint at the origin.

    Args:
        model: of one body alone.
        hulls: let meshes collide as their convex hulls, not as convex parts.

    Raises:
        AssetRefused: it does not collide, has too many faces, or not the size or the weight of a
            thing on a table.
    """
    geoms = range(model.ngeom)
    joints = [int(kind) for kind in model.jnt_type]
    if joints and joints != [mujoco.mjtJoint.mjJNT_FREE]:
        raise _refused(
            f"has {len(joints)} joints; an object is one rigid body, at most on a free one"
        )
    solid = [g for g in geoms if model.geom_contype[g] or model.geom_conaffinity[g]]
    if not solid:
        raise _refused("has no geom that collides; leave contype and conaffinity out")
    surfaces = {geom: _surface(model, geom) for geom in geoms}
    seen = [geom for geom in geoms if model.geom_group[geom] < 3] or solid
    if (faces := sum(len(surfaces[geom].faces) for geom in seen)) > MAX_FACES:
        raise _refused(f"has {faces:,} faces; at most {MAX_FACES:,} are taken")
    corners = np.concatenate([surfaces[geom].vertices for geom in {*seen, *solid}])
    low, high = corners.min(axis=0), corners.max(axis=0)
    if fault := size_fault(high - low, 1.0):
        raise AssetRefused(Fault(field="body", message=fault.message.partition("; if")[0]))
    foot = np.array([*(low + high)[:2] / 2, low[2]])
    parts, primitives = list[Points](), list[Primitive]()
    volume = 0.0
    for geom in solid:
        if model.geom_type[geom] == mjtGeom.mjGEOM_MESH:
            found = _parts(surfaces[geom], hulls=hulls)
            volume += sum(float(trimesh.convex.convex_hull(part).volume) for part in found)
            parts += [part - foot for part in found]
        else:
            volume += float(surfaces[geom].volume)
            primitives.append(_primitive(model, geom, foot))
    mass = float(model.body_mass.sum())
    least, most = DENSITIES
    if not least <= mass / volume <= most:
        message = (
            f"weighs {mass:.4g} kg, {mass / volume:.4g} kg/m³; from {least:g} to {most:g} is taken"
        )
        raise _refused(message)
    looks = tuple(_look(model, geom, surfaces[geom], foot) for geom in seen)
    length, width, height = (round(float(side), 4) for side in high - low)
    return RigidBody(
        shape=Shape(looks, tuple(parts), tuple(primitives)),
        size=(length, width, height),
        volume=volume,
        mass=mass,
        faces=faces,
    )


def _surface(model: mujoco.MjModel, geom: int) -> trimesh.Trimesh:
    """A geom as triangles, in the body's frame."""
    size = model.geom_size[geom]
    match int(model.geom_type[geom]):
        case mjtGeom.mjGEOM_MESH:
            mesh = int(model.geom_dataid[geom])
            first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
            start, faces = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
            drawn = trimesh.Trimesh(
                model.mesh_vert[first : first + count].astype(float),
                model.mesh_face[start : start + faces],
                process=False,
            )
        case mjtGeom.mjGEOM_BOX:
            drawn = trimesh.creation.box(extents=2 * size)
        case mjtGeom.mjGEOM_CYLINDER:
            drawn = trimesh.creation.cylinder(radius=size[0], height=2 * size[1], sections=48)
        case mjtGeom.mjGEOM_CAPSULE:
            drawn = trimesh.creation.capsule(radius=size[0], height=2 * size[1], count=(24, 24))
        case mjtGeom.mjGEOM_SPHERE | mjtGeom.mjGEOM_ELLIPSOID as kind:
            radii = size if kind == mjtGeom.mjGEOM_ELLIPSOID else np.full(3, size[0])
            drawn = trimesh.creation.icosphere(subdivisions=3).apply_scale(radii)
        case kind:
            name = mjtGeom(kind).name.removeprefix("mjGEOM_").lower()
            raise _refused(
                f"has a {name}; box, sphere, ellipsoid, capsule, cylinder and mesh are taken"
            )
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn.reshape(3, 3), model.geom_pos[geom]
    return drawn.apply_transform(pose)


def _parts(surface: trimesh.Trimesh, *, hulls: bool) -> tuple[Points, ...]:
    surface.merge_vertices()
    if hulls:
        return (np.asarray(hull_of(surface).vertices),)
    return convex_parts(surface)


def _primitive(model: mujoco.MjModel, geom: int, foot: Array) -> Primitive:
    a, b, c = model.geom_size[geom].tolist()
    x, y, z = (model.geom_pos[geom] - foot).tolist()
    w, i, j, k = model.geom_quat[geom].tolist()
    return Primitive(int(model.geom_type[geom]), (a, b, c), (x, y, z), (w, i, j, k))


def _look(model: mujoco.MjModel, geom: int, surface: trimesh.Trimesh, foot: Array) -> Look:
    material = int(model.geom_matid[geom])
    rgba = model.mat_rgba[material] if material >= 0 else model.geom_rgba[geom]
    red, green, blue, alpha = (float(share) for share in rgba)
    named = not np.allclose(rgba, UNNAMED, atol=1e-3)
    mesh = Mesh(np.asarray(surface.vertices) - foot, np.asarray(surface.faces, np.int32))
    return Look(mesh, (red, green, blue, alpha) if named else None)


def _refused(message: str) -> AssetRefused:
    return AssetRefused(Fault(field="body", message=message))
