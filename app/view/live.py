"""Frames to scene nodes: a compiled model drawn into a viser scene."""

from typing import NamedTuple

import mujoco
import numpy as np
import viser

from app.view.solids import body_glb

Point = tuple[float, float, float]
"""x, y, z in the model's world [m]."""

CAMERA_POSITION = (1.8, -1.1, 1.0)
CAMERA_TARGET = (0.4, 0.0, 0.14)
"""From the front right, a little above: the arm is seen working towards the watcher [m]."""
CAMERA_FOV = 0.7
"""Vertical angle of view [rad]."""
WATCHER = "watcher"
"""Name of the camera that a model may bring along, looking down at what is to be seen."""
STILL = 1e-6
"""Below this a pose has not changed [m], and for quaternions' components."""


class Limb(NamedTuple):
    """A body that moves within its parent's frame."""

    body_id: int
    parent_id: int
    path: str
    """Name of the scene node that shows it."""


def limbs_of(model: mujoco.MjModel) -> list[Limb]:
    """Everything that can move."""
    paths = paths_of(model)
    return [
        Limb(body_id, int(model.body_parentid[body_id]), paths[body_id])
        for body_id in range(model.nbody)
        if model.body_jntnum[body_id]
    ]


def paths_of(model: mujoco.MjModel) -> list[str]:
    """The scene node of every body, hung into each other as in the model."""
    paths: list[str] = []
    for body_id in range(model.nbody):
        parent_id = int(model.body_parentid[body_id])
        paths.append(f"{paths[parent_id]}/{body_id}" if body_id else "/world")
    return paths


def pose_in_parent(data: mujoco.MjData, limb: Limb) -> tuple[np.ndarray, np.ndarray]:
    """Position [m] (3,) and quaternion wxyz (4,) of the body in its parent's frame."""
    places, turns = data.xpos, data.xquat
    back, turn_back, position, quaternion = (np.empty(size) for size in (3, 4, 3, 4))
    mujoco.mju_negPose(back, turn_back, places[limb.parent_id], turns[limb.parent_id])
    here = (places[limb.body_id], turns[limb.body_id])
    mujoco.mju_mulPose(position, quaternion, back, turn_back, *here)
    return position, quaternion


class Drawing:
    """The bodies of a model in a viser scene.

    A turning joint so costs its watcher one message; what stands still costs none.
    """

    def __init__(self, canvas: viser.ViserServer, model: mujoco.MjModel) -> None:
        self._canvas = canvas
        self._model = model
        self._data = mujoco.MjData(model)
        with canvas.atomic():
            self._furnish()
            nodes = self._draw_bodies()
        self._limbs = [(limb, nodes[limb.body_id]) for limb in limbs_of(model)]
        self.show(model.qpos0)

    def show(self, qpos: np.ndarray) -> None:
        """Put everything where ``qpos`` (nq,) says."""
        self._data.qpos[:] = qpos
        mujoco.mj_kinematics(self._model, self._data)
        with self._canvas.atomic():
            for limb, node in self._limbs:
                _move(node, *pose_in_parent(self._data, limb))

    def _furnish(self) -> None:
        scene = self._canvas.scene
        scene.set_up_direction("+z")
        scene.configure_environment_map("studio", environment_intensity=0.4)
        scene.configure_default_lights(enabled=True, cast_shadow=True)
        camera = self._canvas.initial_camera
        camera.position, camera.look_at, camera.fov = view_of(self._model)

    def _draw_bodies(self) -> list[viser.FrameHandle]:
        nodes: list[viser.FrameHandle] = []
        for body_id, path in enumerate(paths_of(self._model)):
            position, quaternion = self._model.body_pos[body_id], self._model.body_quat[body_id]
            node = self._canvas.scene.add_frame(
                path, show_axes=False, position=position.copy(), wxyz=quaternion.copy()
            )
            nodes.append(node)
            if glb := body_glb(self._model, body_id):
                self._canvas.scene.add_glb(f"{path}/looks", glb)
        return nodes


def view_of(model: mujoco.MjModel) -> tuple[Point, Point, float]:
    """Where a watcher's camera stands and where it looks [m], and its vertical angle [rad].

    A model's own camera looks at the point of the floor (z = 0) in the middle of its picture.
    """
    camera = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, WATCHER)
    if camera < 0:
        return CAMERA_POSITION, CAMERA_TARGET, CAMERA_FOV
    position, axis = model.cam_pos[camera], np.empty(3)
    mujoco.mju_rotVecQuat(axis, np.array((0.0, 0.0, -1.0)), model.cam_quat[camera])
    x, y, z = position.tolist()
    ahead = (position - axis * (z / axis[2])).tolist()
    return (x, y, z), (ahead[0], ahead[1], 0.0), float(np.radians(model.cam_fovy[camera]))


def _move(node: viser.FrameHandle, position: np.ndarray, quaternion: np.ndarray) -> None:
    if np.abs(position - node.position).max() > STILL:
        node.position = position
    if np.abs(quaternion - node.wxyz).max() > STILL:
        node.wxyz = quaternion
