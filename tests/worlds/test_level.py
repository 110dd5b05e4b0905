import numpy as np
import pytest

from app.worlds.simulators.mujoco.arms import arms
from app.worlds.simulators.mujoco.level import Level
from app.worlds.simulators.mujoco.rotation import about

pytestmark = pytest.mark.physics


@pytest.mark.parametrize(("degrees", "lost"), [(0, False), (30, False), (60, True)])
def test_a_vessel_in_the_gripper_may_lean_a_little(tabletop, scene_of, degrees, lost):
    world = tabletop.open(scene_of(cup=(0.5, 0.2)), 0)
    level = Level(world.physics, "cup")
    arm = arms["panda"]
    tool = arm.forward(arm.home)
    tool[:3, :3] = about(np.array([0.0, 1.0, 0.0]), -np.radians(degrees)) @ tool[:3, :3]
    (joints, *_) = arm.inverse(tool, arm.home)
    assert level.lost(joints) == lost
