"""Scene to MuJoCo model: the table, the robot arm, and a free body for every object."""

from dataclasses import dataclass
from functools import cache

import mujoco
import numpy as np

from app.domain.scene import Scene, SceneObject
from app.worlds.simulators.mujoco.arm import Arm
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms
from app.worlds.simulators.mujoco.articulation import Articulation
from app.worlds.simulators.mujoco.beads import COUNT, add_beads, has_beads
from app.worlds.simulators.mujoco.colours import css
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.solid import (
    CONTACT_DIMENSIONS,
    FRICTION,
    STIFFNESS,
    VISUAL_GROUP,
    Solid,
)

TABLE_HALF_EXTENTS = (0.55, 0.75, 0.02)
TABLE_CENTRE = (0.35, 0.0, -0.02)
"""Its top is z = 0, the plane the robot's base stands on [m]."""
FLOOR_HEIGHT = -0.75
CLEARANCE = 0.0005
"""Objects start this far above their place [m] and settle onto it."""
CELLS = 400
"""Into so many cells an object's top is divided where it can be wiped; see ``rubbing``."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ObjectBody:
    """Where an object is in the model, and its measures."""

    name: str
    kind: str
    body_id: int
    qpos_address: int
    """Of its position and quaternion wxyz, seven numbers."""
    dof_address: int
    footprint_radius: float
    """From the body's origin to the farthest corner of its footprint [m]."""
    height: float
    opening: Opening | None
    parts: tuple[int, ...]
    """All its bodies, itself first: a drawer's box moves in its chest."""
    cavity: int
    """The body in whose frame the opening is."""
    articulation: Articulation | None = None
    joint: int | None = None
    """The joint of its moving part, if it has one."""
    start: float = 0.0
    """Where that joint stands at first [m] or [rad]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltScene:
    """The compiled model and its objects by name, in scene order."""

    model: mujoco.MjModel
    bodies: dict[str, ObjectBody]
    arm: Arm
    beads: dict[str, tuple[int, ...]]
    """The bodies of the beads that an object held at first, by its name."""


def build(scene: Scene, *, visuals: bool = True) -> BuiltScene:
    """Compile a completed scene (see ``placement.complete``); the same scene, the same model.

    Geoms of group 2 are to be looked at, those of group 3 collide and are seen by ray cameras;
    ``table`` and ``floor``, of group 0, are all of it. Bodies are named ``object/<index>``.
    Without ``visuals``, what is only to be looked at is left out: the coordinates are the same, and
    the model is ready several times sooner.
    """
    arm = arms[scene.robot or DEFAULT_ARM]
    spec = furnished(arm, visuals=visuals).copy()
    for index, item in enumerate(scene.objects):
        add_object(spec, f"object/{index}", item, visuals=visuals)
    filled: dict[str, str] = {}
    for index, item in enumerate(scene.objects):
        opening = kinds[item.kind or ""].opening(item.size or (0.0, 0.0, 0.0))
        if opening is not None and has_beads(item):
            add_beads(spec, f"object/{index}", item, opening)
            filled[item.name] = f"object/{index}"
    if "wipe" in (scene.actions or ()):
        spec.nuserdata = CELLS * len(scene.objects)
    model = spec.compile()
    beads = {
        name: tuple(int(model.body(f"{body}/bead/{k}").id) for k in range(COUNT))
        for name, body in filled.items()
    }
    bodies = {
        item.name: located(model, f"object/{index}", item, shut=_begins_shut(scene, item))
        for index, item in enumerate(scene.objects)
    }
    return BuiltScene(model=model, bodies=bodies, arm=arm, beads=beads)


def add_object(spec: mujoco.MjSpec, body_name: str, item: SceneObject, *, visuals: bool) -> None:
    if not (item.kind and item.size and item.colour and item.position) or item.yaw is None:
        raise ValueError(f"{item.name!r} is not completed")
    kind = kinds[item.kind]
    x, y, z = item.position
    body = spec.worldbody.add_body(
        name=body_name,
        pos=(x, y, z + CLEARANCE),
        quat=(np.cos(item.yaw / 2), 0, 0, np.sin(item.yaw / 2)),
    )
    body.add_freejoint(name=f"{body_name}/free")
    solid = Solid(spec, body, kind.density)
    kind.build(solid, item.size, css(item.colour))
    if visuals:
        solid.finish()
    articulation = kind.articulation(item.size)
    if articulation is not None:
        part = _add_part(body, articulation)
        moving = Solid(spec, part, kind.part_density)
        kind.build_part(moving, item.size, css(item.colour))
        if visuals:
            moving.finish()


def _add_part(body: mujoco.MjsBody, articulation: Articulation) -> mujoco.MjsBody:
    """The moving part of an object, on its joint."""
    part = body.add_body(name=f"{body.name}/part", pos=articulation.pivot)
    sliding = articulation.joint == "slide"
    joint = mujoco.mjtJoint.mjJNT_SLIDE if sliding else mujoco.mjtJoint.mjJNT_HINGE
    part.add_joint(
        name=f"{body.name}/joint",
        type=joint,
        axis=articulation.axis,
        range=(0, articulation.travel),
        limited=mujoco.mjtLimited.mjLIMITED_TRUE,
        frictionloss=articulation.friction,
        damping=articulation.friction / 2,
        armature=0.01 if sliding else 0.0005,
    )
    return part


def _begins_shut(scene: Scene, item: SceneObject) -> bool:
    """As its client says; else it is open if the robot could not open it."""
    said = dict(item.properties).get("state")
    return said == "closed" or (said != "open" and "open" in (scene.actions or ()))


def located(model: mujoco.MjModel, body_name: str, item: SceneObject, *, shut: bool) -> ObjectBody:
    kind, size = kinds[item.kind or ""], item.size or (0.0, 0.0, 0.0)
    joint = model.joint(f"{body_name}/free")
    body_id = int(model.body(body_name).id)
    articulation = kind.articulation(size)
    part = None if articulation is None else int(model.body(f"{body_name}/part").id)
    return ObjectBody(
        name=item.name,
        kind=kind.name,
        body_id=body_id,
        parts=(body_id,) if part is None else (body_id, part),
        cavity=part if part is not None and articulation and articulation.holds else body_id,
        articulation=articulation,
        joint=None if part is None else int(model.body_jntadr[part]),
        start=0.0 if articulation is None or shut else articulation.travel,
        qpos_address=int(joint.qposadr[0]),
        dof_address=int(joint.dofadr[0]),
        footprint_radius=float(np.hypot(*kind.half_extents(size))),
        height=size[2],
        opening=kind.opening(size),
    )


@cache
def furnished(arm: Arm, *, visuals: bool) -> mujoco.MjSpec:
    """What is the same in every scene with this arm; read once, copied for each."""
    spec = arm.spec()
    for unwanted in (*spec.keys, *spec.lights):
        spec.delete(unwanted)
    for body in spec.bodies[1:]:
        body.gravcomp = 1
    if not visuals:
        _strip(spec)
    spec.modelname = "tabletop"
    spec.option.timestep = 0.002
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    # Elliptic cones with a stiff friction impedance keep what is held from creeping out.
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10
    _add_room(spec)
    return spec


def _strip(spec: mujoco.MjSpec) -> None:
    """Take out what is only to be looked at."""
    for geom in [geom for geom in spec.geoms if geom.group == VISUAL_GROUP]:
        spec.delete(geom)
    used = {geom.meshname for geom in spec.geoms}
    for mesh in [mesh for mesh in spec.meshes if mesh.name not in used]:
        spec.delete(mesh)


def _add_room(spec: mujoco.MjSpec) -> None:
    world = spec.worldbody
    spec.visual.headlight.ambient = (0.35, 0.35, 0.35)
    spec.visual.headlight.diffuse = (0.45, 0.45, 0.45)
    world.add_light(pos=(0.4, 0.3, 2.0), dir=(0, -0.1, -1), diffuse=(0.6, 0.6, 0.58))
    world.add_light(pos=(1.5, -1.0, 1.8), dir=(-0.6, 0.5, -0.8), diffuse=(0.3, 0.3, 0.34))
    world.add_geom(
        name="floor",
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=(3, 3, 0.1),
        pos=(0, 0, FLOOR_HEIGHT),
        rgba=css("#e6e4df"),
    )
    table = world.add_body(name="table", pos=TABLE_CENTRE)
    table.add_geom(
        name="table",
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=TABLE_HALF_EXTENTS,
        rgba=css("#cfae88"),
        friction=FRICTION,
        condim=CONTACT_DIMENSIONS,
        solref=STIFFNESS,
    )
    long, wide, thick = TABLE_HALF_EXTENTS
    leg = (-FLOOR_HEIGHT - 2 * thick) / 2
    for x, y in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        table.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=(0.025, 0.025, leg),
            pos=(x * (long - 0.05), y * (wide - 0.05), -thick - leg),
            rgba=css("#6b5138"),
        )
