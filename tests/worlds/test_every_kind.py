"""One test after another over every object kind there is: a new file is tested at once."""

from functools import lru_cache

import mujoco
import numpy as np
import pytest

from app.domain.scene import SceneObject
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms
from app.worlds.simulators.mujoco.kind import GRIPPER
from app.worlds.simulators.mujoco.objects import kinds, match
from app.worlds.simulators.mujoco.physics import FRICTION_STIFFNESS
from app.worlds.simulators.mujoco.scene_builder import BuiltScene, add_object, located
from app.worlds.simulators.mujoco.solid import (
    COLLISION_GROUP,
    CONTACT_DIMENSIONS,
    FRICTION,
    VISUAL_GROUP,
)

EVERY_KIND = tuple(kinds)
EXTREMES = ("smallest", "largest")


@lru_cache(maxsize=3)
def built(name: str, extreme: str = "largest", *, opened: bool = False):
    """The object alone on a table without an arm, whose meshes would take most of the memory."""
    kind = kinds[name]
    item = SceneObject(
        name=name,
        kind=name,
        colour=kind.colour,
        size=getattr(kind, extreme),
        container=kind.container,
        position=(0.5, 0.1, 0.0),
        yaw=0.4,
    )
    spec = mujoco.MjSpec()
    spec.option.timestep = 0.002
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = FRICTION_STIFFNESS
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=(0.5, 0.5, 0.02),
        pos=(0.5, 0.0, -0.02),
        friction=FRICTION,
        condim=CONTACT_DIMENSIONS,
    )
    add_object(spec, "object/0", item, visuals=True)
    model = spec.compile()
    body = located(model, "object/0", item, shut=not opened)
    return item, BuiltScene(model=model, bodies={name: body}, arm=arms[DEFAULT_ARM], beads={})


def started(name: str, extreme: str, *, opened: bool = False):
    """The object's model, its place in it, and data as it starts."""
    item, scene = built(name, extreme, opened=opened)
    data, body = mujoco.MjData(scene.model), scene.bodies[item.name]
    if body.joint is not None:
        data.qpos[scene.model.jnt_qposadr[body.joint]] = body.start
    return scene.model, body, data


def surface(name: str, extreme: str, group: int) -> np.ndarray:
    """Points on the object's geoms of one group, in its body's frame, shape (n, 3) [m]."""
    # The size of what has a drawer is that with the drawer out.
    model, body, data = started(name, extreme, opened=name == "drawer")
    data.qpos[body.qpos_address : body.qpos_address + 7] = (0, 0, 0, 1, 0, 0, 0)
    mujoco.mj_kinematics(model, data)
    points = []
    for geom in np.flatnonzero(np.isin(model.geom_bodyid, body.parts)):
        if model.geom_group[geom] == group:
            turn = data.geom_xmat[geom].reshape(3, 3)
            points.append(geom_points(model, int(geom)) @ turn.T + data.geom_xpos[geom])
    return np.concatenate(points)


def geom_points(model: mujoco.MjModel, geom: int) -> np.ndarray:
    size, shape = model.geom_size[geom], mujoco.mjtGeom(model.geom_type[geom])
    if shape == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = model.geom_dataid[geom]
        start = model.mesh_vertadr[mesh]
        return model.mesh_vert[start : start + model.mesh_vertnum[mesh]].astype(float)
    across, along = np.meshgrid(np.linspace(0, 2 * np.pi, 33), np.linspace(-1, 1, 17))
    ball = np.stack(
        [
            np.sqrt(1 - along**2) * np.cos(across),
            np.sqrt(1 - along**2) * np.sin(across),
            along,
        ],
        axis=-1,
    ).reshape(-1, 3)
    if shape == mujoco.mjtGeom.mjGEOM_ELLIPSOID:
        return ball * size
    if shape == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return ball * size[0] + np.sign(ball[:, 2:]) * np.array([0, 0, size[1]])
    if shape == mujoco.mjtGeom.mjGEOM_CYLINDER:
        ring = np.stack([np.cos(across), np.sin(across), along], axis=-1).reshape(-1, 3)
        return ring * np.array([size[0], size[0], size[1]])
    assert shape == mujoco.mjtGeom.mjGEOM_BOX
    return np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T * size


def test_there_are_at_least_sixty_kinds():
    assert len(EVERY_KIND) >= 60


@pytest.mark.parametrize("name", EVERY_KIND)
def test_a_kind_is_listed_as_it_is_registered(name):
    entry = kinds[name].entry()
    assert entry.name == name
    assert entry.category
    assert kinds[name].size_fault(entry.size) is None
    assert match(name) == name
    assert [match(word) for word in entry.synonyms] == [name] * len(entry.synonyms)


@pytest.mark.parametrize("name", EVERY_KIND)
@pytest.mark.parametrize("extreme", EXTREMES)
@pytest.mark.parametrize("group", [VISUAL_GROUP, COLLISION_GROUP])
def test_a_kind_fills_the_bounding_box_it_is_given(name, extreme, group):
    kind, points = kinds[name], surface(name, extreme, group)
    size = np.array(getattr(kind, extreme))
    low, high = points.min(axis=0), points.max(axis=0)
    assert low[2] > -0.0005
    assert high[2] <= size[2] + 0.0015
    half = np.array(kind.half_extents(tuple(size)))
    assert (np.abs(np.array([low[:2], high[:2]])) <= half + 0.0015).all()
    if group == VISUAL_GROUP:
        assert np.allclose(high - low, size, rtol=0.07, atol=0.001)
    else:
        assert (high - low > 0.75 * size).all()


@pytest.mark.parametrize("name", EVERY_KIND)
def test_a_kind_has_a_mass_the_arm_can_carry_or_stands_fast(name):
    _, body, _ = started(name, "largest")
    mass = built(name)[1].model.body_subtreemass[body.body_id]
    if body.joint is None:
        assert 0.005 < mass < 1.0
    else:
        assert 0.8 < mass < 4.0


@pytest.mark.physics
@pytest.mark.parametrize("name", EVERY_KIND)
@pytest.mark.parametrize("extreme", EXTREMES)
def test_a_kind_rests_for_two_seconds_where_it_is_put(name, extreme):
    model, body, data = started(name, extreme)
    pose = slice(body.qpos_address, body.qpos_address + 7)
    start = data.qpos[pose].copy()
    mujoco.mj_step(model, data, 250)
    settled = data.qpos.copy()
    deepest = 0.0
    for _ in range(40):
        mujoco.mj_step(model, data, 25)
        deepest = min(deepest, data.contact.dist[: data.ncon].min(initial=0.0))
        assert abs(data.qvel).max() < 0.05
    end = data.qpos[pose]
    assert np.linalg.norm(end[:3] - start[:3]) < 0.002
    assert 2 * np.arccos(min(1.0, abs(end[3:] @ start[3:]))) < np.radians(3)
    assert np.linalg.norm(end[:3] - settled[pose][:3]) < 0.001
    assert 2 * np.arccos(min(1.0, abs(end[3:] @ settled[pose][3:]))) < np.radians(1)
    assert deepest > -0.002


def relief(name: str, extreme: str) -> tuple[np.ndarray, float]:
    """Heights of the collision geoms seen from above [m], and the side of a cell [m]."""
    model, body, data = started(name, extreme, opened=True)
    data.qpos[body.qpos_address : body.qpos_address + 7] = (0.5, 0.1, 0.0, 1, 0, 0, 0)
    mujoco.mj_forward(model, data)
    reach = body.footprint_radius + 0.004
    cell = max(0.002, reach / 32)
    axis = np.arange(-reach, reach, cell)
    groups = np.array([0, 0, 0, 1, 0, 0], np.uint8)
    hit, heights = np.zeros(1, np.int32), np.zeros((len(axis), len(axis)))
    down = np.array([0.0, 0.0, -1.0])
    for row, x in enumerate(axis):
        for column, y in enumerate(axis):
            above = np.array([0.5 + x, 0.1 + y, 0.3])
            distance = mujoco.mj_ray(model, data, above, down, groups, 1, -1, hit)
            if distance >= 0 and model.geom_bodyid[hit[0]] in body.parts:
                heights[row, column] = 0.3 - distance
    return heights, cell


@pytest.mark.parametrize("name", [name for name in EVERY_KIND if not kinds[name].container])
def test_ray_cameras_see_something_a_gripper_can_close_over(name):
    """Along a line through a graspable spot, there is room on both sides within the stroke."""
    heights, cell = relief(name, "largest")
    solid = heights > 0.008
    assert solid.any()
    spans = [
        (line.nonzero()[0][-1] - line.nonzero()[0][0] + 1) * cell
        for lines in (solid, solid.T)
        for line in lines
        if line.any()
    ]
    stated = kinds[name].grip(kinds[name].largest)
    assert stated <= GRIPPER
    assert any(abs(span - stated) < 0.006 for span in spans)


PLAIN = [name for name in EVERY_KIND if kinds[name].container and not kinds[name].faces]


@pytest.mark.parametrize("name", PLAIN)
@pytest.mark.parametrize("extreme", EXTREMES)
def test_a_container_is_open_above_its_floor(name, extreme):
    heights, cell = relief(name, extreme)
    item, scene = built(name, extreme)
    opening = scene.bodies[item.name].opening
    assert opening is not None
    middle = len(heights) // 2
    inside = int(0.35 * opening.radius / cell)
    bottom = heights[middle - inside : middle + inside, middle - inside : middle + inside]
    assert np.abs(bottom - opening.floor).max() < 0.003
    assert abs(heights.max() - opening.rim) < 0.003
    assert opening.rim - opening.floor > 0.010
    assert heights[middle, middle] == pytest.approx(opening.floor, abs=0.002)


@pytest.mark.parametrize("name", EVERY_KIND)
def test_only_containers_have_an_opening(name):
    kind = kinds[name]
    assert (kind.opening(kind.largest) is not None) == kind.container
