"""One test after another over every object kind there is: a new file is tested at once."""

from functools import cache

import mujoco
import numpy as np
import pytest

from app.domain.scene import Scene, SceneObject
from app.worlds.simulators.mujoco.kind import GRIPPER
from app.worlds.simulators.mujoco.objects import kinds, match
from app.worlds.simulators.mujoco.scene_builder import BuiltScene, build
from app.worlds.simulators.mujoco.solid import COLLISION_GROUP, VISUAL_GROUP

EVERY_KIND = tuple(kinds)
EXTREMES = ("smallest", "largest")


@cache
def built(name: str, extreme: str = "largest") -> tuple[SceneObject, BuiltScene]:
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
    return item, build(Scene(world="tabletop", objects=(item,)))


def surface(name: str, extreme: str, group: int) -> np.ndarray:
    """Points on the object's geoms of one group, in its body's frame, shape (n, 3) [m]."""
    item, scene = built(name, extreme)
    model = scene.model
    points = []
    for geom in np.flatnonzero(model.geom_bodyid == scene.bodies[item.name].body_id):
        if model.geom_group[geom] != group:
            continue
        turn = np.zeros(9)
        mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
        local = geom_points(model, int(geom))
        points.append(local @ turn.reshape(3, 3).T + model.geom_pos[geom])
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
def test_a_kind_has_a_mass_the_arm_can_carry(name):
    item, scene = built(name)
    assert 0.005 < scene.model.body_mass[scene.bodies[item.name].body_id] < 1.0


@pytest.mark.physics
@pytest.mark.parametrize("name", EVERY_KIND)
@pytest.mark.parametrize("extreme", EXTREMES)
def test_a_kind_rests_where_it_is_put(name, extreme):
    item, scene = built(name, extreme)
    data = mujoco.MjData(scene.model)
    data.qpos[7:9] = 0.04
    data.ctrl[7] = 255
    data.qpos[3], data.ctrl[3] = -1.6, -1.6
    body = scene.bodies[item.name]
    pose = slice(body.qpos_address, body.qpos_address + 7)
    start = data.qpos[pose].copy()
    mujoco.mj_step(scene.model, data, 400)
    settled = data.qpos[pose].copy()
    mujoco.mj_step(scene.model, data, 600)
    end = data.qpos[pose]
    assert np.linalg.norm(end[:3] - start[:3]) < 0.002
    assert 2 * np.arccos(min(1.0, abs(end[3:] @ start[3:]))) < np.radians(3)
    assert np.linalg.norm(end[:3] - settled[:3]) < 0.0005
    assert 2 * np.arccos(min(1.0, abs(end[3:] @ settled[3:]))) < np.radians(1)


def relief(name: str, extreme: str) -> tuple[np.ndarray, float]:
    """Heights of the collision geoms seen from above [m], and the side of a cell [m]."""
    item, scene = built(name, extreme)
    data = mujoco.MjData(scene.model)
    body = scene.bodies[item.name]
    data.qpos[body.qpos_address : body.qpos_address + 7] = (0.5, 0.1, 0.0, 1, 0, 0, 0)
    mujoco.mj_forward(scene.model, data)
    reach = body.footprint_radius + 0.004
    cell = max(0.002, reach / 32)
    axis = np.arange(-reach, reach, cell)
    groups = np.array([0, 0, 0, 1, 0, 0], np.uint8)
    hit, heights = np.zeros(1, np.int32), np.zeros((len(axis), len(axis)))
    down = np.array([0.0, 0.0, -1.0])
    for row, x in enumerate(axis):
        for column, y in enumerate(axis):
            above = np.array([0.5 + x, 0.1 + y, 0.3])
            distance = mujoco.mj_ray(scene.model, data, above, down, groups, 1, -1, hit)
            if distance >= 0 and scene.model.geom_bodyid[hit[0]] == body.body_id:
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


@pytest.mark.parametrize("name", [name for name in EVERY_KIND if kinds[name].container])
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
