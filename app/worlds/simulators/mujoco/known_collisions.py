"""Collision checks that know the simulator's own geometry and poses."""

import copy
from collections.abc import Iterator
from contextlib import contextmanager

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import CARRIED, OBSTACLE, Collisions
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.surface import surface_points

Array = NDArray[np.float64]


class KnownCollisions(Collisions):
    """Checks against a scratch copy of the scene."""

    def __init__(self, physics: Physics) -> None:
        super().__init__(copy.copy(physics.model), physics.arm)
        self._physics = physics
        self._names = {part: name for name, b in physics.bodies.items() for part in b.parts}
        self._load: tuple[int, Array] | None = None

    def refresh(self) -> None:
        """Take over the positions of the objects from the physics."""
        self._data.qpos[:] = self._physics.data.qpos

    def recall(self) -> None:
        """The same: the simulator need not look."""
        self.refresh()

    @contextmanager
    def carrying(self, name: str) -> Iterator[None]:
        """Within this, the object moves with the hand and is itself tested against obstacles."""
        body = self._physics.bodies[name]
        data = self._physics.stand()
        pose = np.eye(4)
        pose[:3, :3] = data.xmat[body.body_id].reshape(3, 3)
        pose[:3, 3] = data.xpos[body.body_id]
        self._carried = self._model.geom_bodyid == body.body_id
        self._set_masks(self._carried, CARRIED)
        in_tool = np.linalg.inv(self.arm.forward(self._physics.joints)) @ pose
        self._load = (body.qpos_address, in_tool)
        try:
            yield
        finally:
            self._set_masks(self._carried, OBSTACLE)
            self._carried = np.zeros_like(self._carried)
            self._load = None

    @contextmanager
    def grasping(self, name: str, cloud: Cloud) -> Iterator[None]:
        """Nothing changes: the object's own geometry is an obstacle to the fingers."""
        del name, cloud  # Unused.
        yield

    def shape(self, name: str) -> tuple[Array, Array]:
        """Points of an object's surface and its middle; see ``Collisions``."""
        data = self._physics.stand()
        body = self._physics.bodies[name].body_id
        mujoco.mj_comPos(self._physics.model, data)
        points = surface_points(self._physics.model, data, body)
        box = (points.min(axis=0) + points.max(axis=0)) / 2
        return points, (box + data.xipos[body]) / 2

    def _bring_along(self, joints: Array) -> None:
        if self._load is None:
            return
        address, object_in_tool = self._load
        pose = self.arm.forward(joints) @ object_in_tool
        qpos = self._data.qpos
        qpos[address : address + 3] = pose[:3, 3]
        mujoco.mju_mat2Quat(qpos[address + 3 : address + 7], pose[:3, :3].reshape(-1))

    def _label(self, geom: int, place: Array) -> str:
        del place  # Unused: every geom is of one thing.
        if name := self._names.get(int(self._model.geom_bodyid[geom])):
            return name
        if self._is_robot[geom]:
            return self._robot_label(geom)
        return f"the {self._model.geom(geom).name or 'table'}"
