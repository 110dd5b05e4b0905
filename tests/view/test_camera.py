"""Where a watcher looks from."""

import mujoco
import numpy as np
import pytest

from app.domain.scene import Scene
from app.view.live import CAMERA_FOV, CAMERA_POSITION, CAMERA_TARGET, view_of
from app.worlds import worlds
from app.worlds.household import Household


def test_model_without_a_camera_is_seen_as_the_tabletop():
    model = mujoco.MjSpec().compile()
    assert view_of(model) == (CAMERA_POSITION, CAMERA_TARGET, CAMERA_FOV)


def test_camera_of_a_model_looks_at_the_floor_in_the_middle_of_its_picture():
    spec = mujoco.MjSpec()
    turn = np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, np.array((1.0, 0.0, 0.0)), np.pi / 4)
    spec.worldbody.add_camera(name="watcher", pos=(1, -2, 2), quat=turn, fovy=30)
    position, target, angle = view_of(spec.compile())
    assert position == (1, -2, 2)
    assert target == pytest.approx((1, 0, 0))
    assert angle == pytest.approx(np.radians(30))


@pytest.mark.parametrize("environment", ["env0", "env1", "env2"])
def test_whole_home_is_in_its_cameras_picture(environment):
    scene = worlds["household"].complete(Scene(world="household", environment=environment), 0)
    model = Household().model(scene)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    camera = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, "watcher")
    seen = (data.geom_xpos - data.cam_xpos[camera]) @ data.cam_xmat[camera].reshape(3, 3)
    half = -seen[:, 2] * np.tan(np.radians(model.cam_fovy[camera]) / 2)
    inside = (np.abs(seen[:, 1]) < half) & (np.abs(seen[:, 0]) < half * 4 / 3)
    assert inside.mean() > 0.97
    assert np.degrees(np.arccos(data.cam_xmat[camera].reshape(3, 3)[2, 2])) < 30
