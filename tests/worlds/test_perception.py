"""What a robot with noisy cameras takes to be there, against what is there."""

import mujoco
import numpy as np
import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.perception import Perception
from app.worlds.simulators.mujoco.arms import arms
from app.worlds.simulators.mujoco.outline import KnownOutlines, SeenOutlines
from app.worlds.simulators.mujoco.picking import CLEARANCE
from app.worlds.simulators.mujoco.placing import LOWERING
from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.workcell import Workcell

pytestmark = pytest.mark.physics
SEEING = Perception(noise=0.002)


@pytest.fixture
def cell_of(tabletop, scene_of):
    def build_cell(perception=SEEING, **places):
        scene = tabletop.complete(scene_of(**places), 1)
        cell = Workcell.over(build(scene, visuals=False), perception, 3)
        cell.physics.settle()
        return cell

    return build_cell


def pointing_down(x, y, z):
    tool = np.diag([1.0, -1.0, -1.0, 1.0])
    tool[:3, 3] = x, y, z
    arm = arms["panda"]
    return arm.inverse(tool, arm.home)[0]


def test_noisy_clouds_lie_within_millimetres_of_the_true_surface(cell_of):
    cell = cell_of(red_block=(0.5, 0.1), pen=(0.35, -0.2))
    points = cell.look_at("red block")["red block"].points
    data, model = cell.physics.stand(), cell.physics.model
    geom = int(model.body_geomadr[cell.physics.bodies["red block"].body_id])
    local = (points - data.geom_xpos[geom]) @ data.geom_xmat[geom].reshape(3, 3)
    outside = np.abs(local) - model.geom_aabb[geom][3:]
    distance = np.abs(outside.max(axis=1))
    assert len(points) > 1000
    assert np.mean(distance) < 0.0012
    assert np.quantile(distance, 0.99) < 0.005


def test_a_look_at_the_same_moment_shows_the_same(cell_of):
    first, second = (cell_of(apple=(0.5, 0.1)).look_at("apple")["apple"] for _ in range(2))
    assert np.array_equal(first.points, second.points)


@pytest.mark.parametrize("name", ["bowl", "plate", "box", "tray", "basket"])
def test_a_containers_outline_is_found_in_what_is_seen(cell_of, name):
    cell = cell_of(**{name: (0.5, 0.1)}, apple=(0.4, -0.3))
    body, clouds = cell.physics.bodies[name], cell.look_at(name)
    seen = SeenOutlines().of(body, clouds)
    known = KnownOutlines(cell.physics).of(body, clouds)
    assert seen.rim == pytest.approx(known.rim, abs=0.004)
    assert np.linalg.norm(seen.centre - known.centre) < 0.006
    assert seen.inset(known.centre) == pytest.approx(known.inset(known.centre), abs=0.012)


def test_a_bowl_upside_down_is_seen_to_be(cell_of):
    cell = cell_of(bowl=(0.5, 0.1))
    body = cell.physics.bodies["bowl"]
    address = body.qpos_address
    cell.physics.data.qpos[address : address + 7] = (0.5, 0.1, 0.06, 0, 1, 0, 0)
    cell.physics.settle()
    with pytest.raises(ActionFailure, match="tipped over"):
        SeenOutlines().of(body, cell.look_at("bowl"))


def test_the_gripper_hits_what_is_seen_and_what_it_hits_has_a_name(cell_of):
    cell = cell_of(red_block=(0.5, 0.0), pen=(0.4, 0.3))
    cell.collisions.refresh()
    inside = cell.collisions.find(pointing_down(0.5, 0.0, 0.02), 0.0, 0.003)
    assert str(inside) == "the gripper with red block"
    assert cell.collisions.find(pointing_down(0.5, -0.2, 0.05), 0.04, 0.003) is None
    table = cell.collisions.find(pointing_down(0.5, -0.2, -0.02), 0.04, 0.003)
    assert str(table) == "the gripper with the table"


def test_what_is_about_to_be_grasped_may_be_between_the_fingers_but_not_in_one(cell_of):
    cell = cell_of(red_block=(0.5, 0.0))
    cloud = cell.look_at("red block")["red block"]
    half = float(cloud.highest[1] - cloud.lowest[1]) / 2
    cell.collisions.refresh()
    with cell.collisions.grasping("red block", cloud):
        around = cell.collisions.find(pointing_down(0.5, 0.0, 0.02), half + 0.008, 0.0005)
        beside = cell.collisions.find(pointing_down(0.5, half + 0.01, 0.02), half, 0.0005)
    assert around is None
    assert str(beside) == "the gripper with red block"
    assert cell.collisions.find(pointing_down(0.5, 0.0, 0.02), 0.0, 0.0005) is not None


def test_what_is_carried_keeps_farther_from_what_it_passes_than_from_where_it_is_put(cell_of):
    cell = cell_of(red_block=(0.5, 0.0), cracker_box=(0.5, -0.3))
    physics, top = cell.physics, cell.physics.bodies["cracker box"].height
    address = physics.bodies["red block"].qpos_address
    joints = pointing_down(0.5, 0.0, 0.32)
    physics.data.qpos[physics.arm.arm_part] = joints
    physics.data.qpos[address : address + 3] = 0.5, 0.0, 0.3
    close = pointing_down(0.5, -0.3, 0.32 - 0.3 + top + 0.004)
    cell.collisions.refresh()
    with cell.collisions.carrying("red block"):
        passing = cell.collisions.find(close, 0.04, CLEARANCE)
        lowering = cell.collisions.find(close, 0.04, LOWERING)
    assert str(passing) == "red block with cracker box"
    assert lowering is None


def test_beliefs_follow_what_happens(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(strawberry=(0.5, 0.2), bowl=(0.5, -0.1), book=(0.35, 0.0)), 0)
    cell = world._cell
    wanted = Relation("in", ("strawberry", "bowl"))
    assert not cell.relations.holds(wanted)
    held = False
    for stage in world.perform("grab_and_putin", ("strawberry", "bowl")):
        if stage.name == "carry" and not held:
            held = cell.relations.holds(Relation("held", ("strawberry",)))
    assert held
    assert cell.relations.facts() == cell.truth.facts() == {wanted}
    assert cell.relations.holds(Relation("left_of", ("book", "bowl")))


def test_what_leans_on_a_container_from_the_table_is_not_taken_to_be_in_it(cell_of):
    cell = cell_of(bowl=(0.5, 0.1), knife=(0.3, -0.3))
    address, half = cell.physics.bodies["knife"].qpos_address, np.radians(40) / 2
    pose = (0.43, 0.1, 0.07, np.cos(half), 0.0, -np.sin(half), 0.0)
    cell.physics.data.qpos[address : address + 7] = pose
    assert cell.look_at("knife", "bowl")["knife"].lowest[2] < 0.012
    assert not cell.relations.holds(Relation("in", ("knife", "bowl")))


def test_who_takes_one_object_for_another_moves_the_wrong_one(tabletop, scene_of, carry_out):
    scene = scene_of(apple=(0.5, 0.2), lemon=(0.5, -0.25), plate=(0.4, 0.0), fork=(0.35, 0.3))
    world = tabletop.open(scene, 1, Perception(confusion=1.0))
    seen = world._cell.look_at()
    true = {
        name: world.physics.data.qpos[b.qpos_address :][:2]
        for name, b in world.physics.bodies.items()
    }
    nearest = {
        name: min(
            true, key=lambda n, c=cloud: np.linalg.norm((c.lowest + c.highest)[:2] / 2 - true[n])
        )
        for name, cloud in seen.items()
    }
    assert all(nearest[name] != name for name in nearest)


def test_privileged_perception_is_exact(cell_of):
    cell = cell_of(Perception(source="privileged"), red_block=(0.5, 0.1))
    cloud = cell.look_at("red block")["red block"]
    assert cloud.highest[2] == pytest.approx(cell.physics.bodies["red block"].height, abs=0.0005)


def test_an_unreachable_object_is_explained_with_the_distance_and_the_pose(
    tabletop, scene_of, carry_out, move
):
    world = tabletop.open(scene_of(block=(0.5, 0.2), bowl=(0.5, -0.1)), 0)
    move(world, "block", (0.8, 0.5, 0.0))
    world.settle()
    with pytest.raises(ActionFailure, match=r"missed by 0\.\d\d m") as failure:
        carry_out(world, "block", "bowl")
    assert failure.value.stage == "unreachable"
    assert failure.value.pose is not None
    assert np.linalg.norm(np.subtract(failure.value.pose.position[:2], (0.8, 0.5))) < 0.1
    assert np.linalg.norm(failure.value.pose.quaternion) == pytest.approx(1.0)


def test_a_model_without_visuals_moves_alike(tabletop, scene_of):
    scene = tabletop.complete(scene_of(mug=(0.5, 0.1), banana=(0.4, -0.2)), 0)
    full, bare = build(scene).model, build(scene, visuals=False).model
    assert (full.nq, full.nv, full.nu, full.nbody) == (bare.nq, bare.nv, bare.nu, bare.nbody)
    assert np.array_equal(full.body_mass, bare.body_mass)
    assert bare.ngeom < full.ngeom
    assert mujoco.mj_name2id(bare, mujoco.mjtObj.mjOBJ_SITE, "tcp") >= 0
