import numpy as np
import pytest

from app.domain.perception import Perception
from app.domain.scene import Scene, SceneObject
from app.worlds.simulators.mujoco.camera import CAMERAS
from app.worlds.simulators.mujoco.cameras import GROUPS
from app.worlds.simulators.mujoco.raycast import cast
from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.silhouettes import Silhouettes, pixels_of
from app.worlds.simulators.mujoco.workcell import Workcell

pytestmark = pytest.mark.physics


@pytest.fixture
def cell(tabletop, scene_of):
    scene = scene_of(red_block=(0.5, 0.2), bowl=(0.5, -0.2), pen=(0.35, 0.0), apple=(0.6, 0.0))
    return Workcell.over(build(tabletop.complete(scene, 1)))


def test_every_object_is_seen_even_a_thin_one(cell):
    assert set(cell.cameras.overview()) == {"red block", "bowl", "pen", "apple"}


def test_the_cloud_of_a_block_lies_on_its_faces(cell):
    cloud = cell.look_at("red block")["red block"]
    size = np.array(cell.physics.bodies["red block"].height)
    assert len(cloud) > 500
    assert cloud.highest[2] == pytest.approx(size, abs=0.002)
    assert np.allclose(np.linalg.norm(cloud.normals, axis=1), 1.0)
    middle = (cloud.lowest + cloud.highest) / 2
    outward = ((cloud.points - middle) * cloud.normals).sum(axis=1)
    assert np.all(outward > 0)


def test_a_look_at_one_object_never_coarsens_another(cell):
    together = cell.look_at("apple", "bowl")
    alone = cell.look_at("apple")
    assert len(together["apple"]) >= len(alone["apple"])


def test_looking_changes_nothing(cell):
    before = cell.physics.save()
    cell.look_at("apple", "bowl")
    assert cell.physics.save() == before


def test_a_thin_thing_in_the_gripper_is_found_from_close_up(tabletop):
    pen = SceneObject(name="pen", position=(0.6, 0.0, 0.0), size=(0.12, 0.007, 0.007))
    scene = tabletop.complete(Scene(world="tabletop", objects=(pen,)), 1)
    cell = Workcell.over(build(scene, visuals=False), Perception(), 3)
    physics = cell.physics
    tool = np.array([[0.0, 1, 0, 0.6], [1, 0, 0, 0.0], [0, 0, -1, 0.125], [0, 0, 0, 1]])
    physics.data.qpos[physics.arm.arm_part] = physics.arm.inverse(tool, physics.arm.home)[0]
    physics.data.qpos[physics.arm.finger_part] = physics.arm.finger_joints_at(0.004)
    address = physics.bodies["pen"].qpos_address
    physics.data.qpos[address : address + 7] = (0.6, 0.0, 0.12, 0.5**0.5, 0.0, 0.0, 0.5**0.5)
    assert "pen" not in cell.cameras.overview()
    assert len(cell.look_at("pen")["pen"]) > 300


def test_rays_past_the_objects_need_not_be_cast(tabletop, scene_of):
    scene = scene_of(drill=(0.5, 0.2), bowl=(0.5, -0.2), pen=(0.35, 0.0), lemon=(0.6, 0.0))
    cell = Workcell.over(build(tabletop.complete(scene, 1)))
    physics = cell.physics
    data = physics.stand()
    parts = [part for body in physics.bodies.values() for part in body.parts]
    corners = Silhouettes(physics.model, parts, GROUPS).corners(data)
    rows, columns = (grid.ravel() for grid in np.mgrid[:120, :160])
    for camera in CAMERAS:
        mask = pixels_of(corners, camera, (160, 120))
        met = cast(physics.model, data, camera, (160, 120), (rows, columns), GROUPS)
        shows = (met.geoms >= 0) & np.isin(physics.model.geom_bodyid[met.geoms], parts)
        assert shows.any()
        assert not (shows & ~mask.ravel()).any()
        assert mask.mean() < 0.2


def test_a_pen_on_the_table_that_the_overview_misses_is_found(tabletop):
    pen = SceneObject(name="pen", position=(0.56, -0.3, 0.0), size=(0.135, 0.011, 0.011))
    scene = tabletop.complete(Scene(world="tabletop", objects=(pen,)), 1)
    cells = [Workcell.over(build(scene, visuals=False), Perception(), seed) for seed in range(40)]
    missed = [cell for cell in cells if "pen" not in cell.cameras.overview()]
    assert missed
    for cell in missed:
        assert len(cell.look_at("pen")["pen"]) > 300


def test_a_close_up_that_shows_a_part_of_a_neighbour_does_not_stand_for_all_of_it(
    tabletop, scene_of
):
    scene = tabletop.complete(scene_of(pen=(0.5, 0.09), bin=(0.5, -0.05)), 1)
    cell = Workcell.over(build(scene, visuals=False), Perception(), 3)
    whole = cell.cameras.overview()["bin"]
    seen = cell.look_at("pen")["bin"]
    assert np.allclose(seen.lowest, whole.lowest, atol=0.02)
    assert np.allclose(seen.highest, whole.highest, atol=0.02)
