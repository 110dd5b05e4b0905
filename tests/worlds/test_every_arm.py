"""One test after another over every robot arm there is: a new file is tested at once."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.condition import Relation
from app.domain.errors import SceneRefused
from app.domain.scene import Scene, SceneObject
from app.worlds import worlds
from app.worlds.simulators.mujoco.arm import CLEARANCE
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms

each = pytest.mark.parametrize("arm", [arms[name] for name in arms], ids=list(arms))


@pytest.fixture(scope="module")
def model_of():
    """The compiled model of an arm alone, and data for it."""

    def compiled(arm):
        model = arm.spec().compile()
        return model, mujoco.MjData(model)

    return compiled


@each
@settings(deadline=None, max_examples=40)
@given(data=st.data())
def test_every_solution_brings_the_tool_to_the_pose_asked_for(arm, data):
    low, high = arm.lowest + 2 * CLEARANCE, arm.highest - 2 * CLEARANCE
    joints = np.array([data.draw(st.floats(a, b)) for a, b in zip(low, high, strict=True)])
    pose = arm.forward(joints)
    for found in arm.inverse(pose, arm.home):
        assert np.allclose(arm.forward(found), pose, atol=2e-4)
        assert np.all(found > arm.lowest)
        assert np.all(found < arm.highest)


@each
def test_the_angles_a_pose_comes_from_are_found_again(arm):
    rng = np.random.default_rng(0)
    low, high = arm.lowest + 2 * CLEARANCE, arm.highest - 2 * CLEARANCE
    again = 0
    for joints in rng.uniform(low, high, (100, arm.joints)):
        found = arm.inverse(arm.forward(joints), joints, np.zeros(1))
        again += len(found) > 0 and float(np.abs(found[0] - joints).max()) < 1e-3
    assert again >= 80  # where the elbow is nearly stretched, ``frankik`` loses some


@each
def test_the_closed_form_agrees_with_the_model(arm, model_of):
    model, data = model_of(arm)
    site = next(i for i in range(model.nsite) if model.site(i).name.endswith("tcp"))
    rng = np.random.default_rng(1)
    for joints in rng.uniform(arm.lowest, arm.highest, (20, arm.joints)):
        data.qpos[arm.arm_part] = joints
        mujoco.mj_kinematics(model, data)
        pose = arm.forward(joints)
        assert np.allclose(data.site_xpos[site], pose[:3, 3], atol=5e-4)
        assert np.allclose(data.site_xmat[site].reshape(3, 3), pose[:3, :3], atol=2e-3)


@each
def test_solutions_come_with_the_least_motion_first(arm):
    found = arm.inverse(arm.forward(arm.home), arm.home)
    assert len(found) > 1
    largest = np.abs(found - arm.home).max(axis=1)
    assert largest[0] == pytest.approx(largest.min(), abs=0.3)


@each
def test_a_pose_out_of_reach_has_no_solution_and_says_by_how_much(arm):
    pose = arm.forward(arm.home)
    pose[0, 3] = 1.1
    assert arm.inverse(pose, arm.home).shape == (0, arm.joints)
    assert "missed by" in arm.missed(pose, arm.home)


@each
def test_a_line_is_straight_and_keeps_the_orientation(arm):
    start = arm.forward(arm.home)
    end = start.copy()
    end[2, 3] -= 0.1
    path = arm.line(start, end, arm.home)
    assert path is not None
    poses = np.array([arm.forward(joints) for joints in path])
    assert np.allclose(poses[:, :2, 3], start[:2, 3], atol=1e-4)
    assert np.allclose(poses[:, :3, :3], start[:3, :3], atol=2e-4)
    assert np.all(np.diff(poses[:, 2, 3]) < 0)
    assert np.allclose(poses[-1], end, atol=2e-4)


@each
def test_a_line_that_leaves_the_reach_is_refused(arm):
    start = arm.forward(arm.home)
    end = start.copy()
    end[0, 3] += 0.8
    assert arm.line(start, end, arm.home) is None


@each
def test_the_fingers_are_where_the_opening_says(arm, model_of):
    model, data = model_of(arm)
    bodies = [model.body(name).id for name in arm.fingers]
    apart = []
    for opening in (0.0, 0.5 * arm.largest_opening, arm.largest_opening):
        joints = arm.finger_joints_at(opening)
        assert arm.opening_at(joints) == pytest.approx(opening, abs=1e-9)
        assert arm.commanded_at(arm.control_at(opening)) == pytest.approx(opening, abs=1e-9)
        data.qpos[arm.finger_part] = joints
        mujoco.mj_kinematics(model, data)
        apart.append(float(np.linalg.norm(np.subtract(*data.xpos[bodies]))))
    assert np.diff(apart) == pytest.approx([arm.largest_opening] * 2, abs=1e-3)


@each
def test_its_own_limits_are_within_the_makers(arm):
    limits = arm.limits
    assert np.all(arm.lowest >= np.array(limits.lowest) - 1e-9)
    assert np.all(arm.highest <= np.array(limits.highest) + 1e-9)
    assert np.all(arm.speed <= limits.speed)
    assert 2 * arm.largest_opening <= limits.opening


@pytest.mark.physics
@pytest.mark.parametrize("name", arms)
def test_every_arm_picks_places_and_comes_home(name, tabletop, scene_of, carry_out):
    scene = replace(scene_of(banana=(0.5, 0.2), bowl=(0.5, -0.1), can=(0.4, 0.1)), robot=name)
    world = tabletop.open(scene, 0)
    carry_out(world, "banana", "bowl")
    assert world.holds(Relation("in", ("banana", "bowl")))
    assert np.abs(world.physics.joints - arms[name].home).max() < 0.02
    assert world.physics.opening > 0.9 * arms[name].largest_opening


@pytest.mark.physics
@pytest.mark.parametrize("name", arms)
def test_the_fingers_stop_at_what_they_hold(name, tabletop, scene_of, carry_out):
    world = tabletop.open(replace(scene_of(block=(0.5, 0.1)), robot=name), 0)
    carry_out(world, "block", action="pick")
    width = world.scene.objects[0].size[0]
    assert world.holds(Relation("held", ("block",)))
    assert 2 * world.physics.opening == pytest.approx(width, abs=0.006)


def test_a_scene_without_a_robot_gets_the_usual_one(tabletop):
    scene = Scene(world="tabletop", objects=(SceneObject(name="cup"),))
    completed = tabletop.complete(scene, 0)
    assert completed.robot == DEFAULT_ARM
    assert tabletop.complete(completed, 0) == completed


def test_an_unknown_robot_is_refused_with_those_there_are(tabletop):
    scene = Scene(world="tabletop", robot="c3po", objects=(SceneObject(name="cup"),))
    with pytest.raises(SceneRefused, match="panda, ur5e") as refused:
        tabletop.complete(scene, 0)
    assert refused.value.faults[0].field == "scene.robot"


def test_a_home_has_no_choice_of_robots():
    with pytest.raises(SceneRefused) as refused:
        worlds["household"].complete(Scene(world="household", robot="panda"), 0)
    assert refused.value.faults[0].field == "scene.robot"
