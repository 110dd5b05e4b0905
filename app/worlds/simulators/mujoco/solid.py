"""Solid: one object's body in a MuJoCo specification, as its kind shapes it.

Visual geoms are meshes of group 2 and touch nothing. Collision geoms are convex, of group 3, carry
the mass, and are also what the ray cameras see, so that a grasp seen is a grasp touched.
"""

from collections.abc import Sequence

import mujoco
import numpy as np

from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.shapes import Mesh, Points, merged
from app.worlds.simulators.mujoco.solid_shape import Primitive

VISUAL_GROUP = 2
COLLISION_GROUP = 3
FRICTION = (1.0, 0.005, 0.002)
"""Sliding [-], torsional [m], rolling [m]."""
CONTACT_DIMENSIONS = 6
STIFFNESS = (0.005, 1.0)
"""Time constant [s] and damping ratio of contacts. At MuJoCo's 0.02 s, what is held creeps out of the
fingers by a centimetre in a fast carry, and a falling fork goes through the floor of a bin."""
PAD_FRICTION = (1.5, 0.02, 0.002)
"""Of the robots' finger pads, likewise."""
Point = Sequence[float]


class Solid:
    """The body's frame: z up, origin under the middle of the object at rest."""

    def __init__(self, spec: mujoco.MjSpec, body: mujoco.MjsBody, density: float) -> None:
        self._spec = spec
        self._body = body
        self._density = density
        self._visuals: dict[Colour, list[Mesh]] = {}
        self._hulls = 0

    def show(self, colour: Colour, *meshes: Mesh) -> None:
        """Let these be seen in one colour."""
        self._visuals.setdefault(colour, []).extend(meshes)

    def box(self, half: Point, centre: Point, turn: Point = (1, 0, 0, 0)) -> None:
        """Collide as a box of these half extents [m]; ``turn`` is a quaternion wxyz."""
        self._collide(mujoco.mjtGeom.mjGEOM_BOX, size=half, pos=centre, quat=turn)

    def ellipsoid(self, radii: Point, centre: Point) -> None:
        """Collide as an ellipsoid with these half axes [m]."""
        self._collide(mujoco.mjtGeom.mjGEOM_ELLIPSOID, size=radii, pos=centre)

    def sphere(self, radius: float, centre: Point) -> None:
        """Collide as a sphere [m]."""
        self._collide(mujoco.mjtGeom.mjGEOM_SPHERE, size=(radius, 0, 0), pos=centre)

    def cylinder(self, radius: float, start: Point, end: Point) -> None:
        """Collide as a cylinder between the middles of its two ends [m]."""
        ends = (*start, *end)
        self._collide(mujoco.mjtGeom.mjGEOM_CYLINDER, size=(radius, 0, 0), fromto=ends)

    def capsule(self, radius: float, start: Point, end: Point) -> None:
        """Collide as a cylinder with a half ball of the same radius about each end [m]."""
        ends = (*start, *end)
        self._collide(mujoco.mjtGeom.mjGEOM_CAPSULE, size=(radius, 0, 0), fromto=ends)

    def hull(self, points: Points) -> None:
        """Collide as the convex hull of these points, shape (n, 3), [m]."""
        name = f"{self._body.name}/hull{self._hulls}"
        self._hulls += 1
        # MuJoCo makes the hull itself; rounding keeps points that should coincide together.
        self._spec.add_mesh(name=name, uservert=np.round(points, 7).reshape(-1))
        self._collide(mujoco.mjtGeom.mjGEOM_MESH, meshname=name)

    def primitive(self, shape: Primitive) -> None:
        """Collide as one of MuJoCo's own shapes, with its measures."""
        self._collide(
            mujoco.mjtGeom(shape.type), size=shape.size, pos=shape.centre, quat=shape.turn
        )

    def _collide(self, shape: mujoco.mjtGeom, **geometry: object) -> None:
        self._body.add_geom(
            type=shape,
            group=COLLISION_GROUP,
            density=self._density,
            condim=CONTACT_DIMENSIONS,
            solref=STIFFNESS,
            friction=FRICTION,
            rgba=(0.6, 0.6, 0.6, 1.0),
            **geometry,
        )

    def finish(self) -> None:
        """Add what is to be seen, one geom a colour."""
        for index, (colour, meshes) in enumerate(self._visuals.items()):
            name = f"{self._body.name}/visual{index}"
            mesh = merged(*meshes)
            added = self._spec.add_mesh(
                name=name,
                uservert=mesh.vertices.reshape(-1),
                userface=mesh.faces.reshape(-1),
            )
            # Surfaces may be open or thin; as a shell they still have a well-defined frame.
            added.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
            self._body.add_geom(
                type=mujoco.mjtGeom.mjGEOM_MESH,
                meshname=name,
                group=VISUAL_GROUP,
                contype=0,
                conaffinity=0,
                mass=0,
                rgba=colour,
            )
