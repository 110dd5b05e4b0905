"""Collision checks of the arm, and of what it carries, against everything else."""

import copy
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.kinematics import forward
from app.worlds.simulators.mujoco.physics import ARM, FINGERS, Physics
from app.worlds.simulators.mujoco.scene_builder import ObjectBody

Array = NDArray[np.float64]

WIDEST_MARGIN = 0.006
"""Gaps of the arm up to this are measured; a clearance can be no larger [m]."""
SELF_OVERLAP = -0.001
CARRIED_OVERLAP = -0.0015
"""Overlaps up to this are contact, not collision: of the arm's own links, of what is carried [m]."""
_OBSTACLE, _ROBOT, _CARRIED = 1, 2, 4
"""Bits of ``contype``. Obstacles ask for no contact, so they are never tested with each other."""
_ROBOT_MEETS = _OBSTACLE | _ROBOT
_CARRIED_MEETS = _OBSTACLE
_HAND = ("hand", "left_finger", "right_finger")


@dataclass(frozen=True, slots=True)
class Carried:
    """An object in the gripper."""

    name: str
    object_in_tool: Array
    """Pose of its body in the tool frame, shape (4, 4)."""


@dataclass(frozen=True, slots=True)
class Collision:
    """Two things that would hit one another, called as the client calls them."""

    first: str
    second: str

    def __str__(self) -> str:
        return f"{self.first} with {self.second}"


class Collisions:
    """Would the arm hit something? Asked of a scratch copy of the scene, never of the physics.

    ``refresh`` takes over where the objects stand now.
    """

    def __init__(self, physics: Physics) -> None:
        self._physics = physics
        self._model = copy.copy(physics.model)
        self._data = mujoco.MjData(self._model)
        self._labels = _labels(self._model, physics.bodies)
        self._robot_bodies = _robot_bodies(self._model)
        self._is_robot = self._robot_bodies[self._model.geom_bodyid]
        self._solid = (self._model.geom_contype != 0) | (self._model.geom_conaffinity != 0)
        self._carried = np.zeros(self._model.ngeom, bool)
        self._set_masks(self._is_robot, _ROBOT, _ROBOT_MEETS)
        self._set_masks(~self._is_robot, _OBSTACLE, 0)
        self._model.geom_margin[:] = np.where(self._is_robot, WIDEST_MARGIN, 0.0)
        self._model.geom_gap[:] = 0.0
        self._model.body_margin[:] = np.where(self._robot_bodies, WIDEST_MARGIN, 0.0)
        self.checks = 0

    def refresh(self) -> None:
        """Take over the positions of the objects from the physics."""
        self._data.qpos[:] = self._physics.data.qpos

    @contextmanager
    def carrying(self, carried: Carried) -> Iterator[None]:
        """Within this, the object moves with the hand and is itself tested against obstacles."""
        body = self._physics.bodies[carried.name]
        self._carried = self._model.geom_bodyid == body.body_id
        self._set_masks(self._carried, _CARRIED, _CARRIED_MEETS)
        self._load = (body.qpos_address, carried.object_in_tool)
        try:
            yield
        finally:
            self._set_masks(self._carried, _OBSTACLE, 0)
            self._carried = np.zeros_like(self._carried)
            self._load = None

    _load: tuple[int, Array] | None = None

    def find(self, joints: Array, opening: float, clearance: float) -> Collision | None:
        """The first collision of the arm at these joint angles, or None.

        Args:
            joints: the arm's joint angles, shape (7,) [rad].
            opening: distance of each finger from the middle [m].
            clearance: the gap to keep from obstacles, up to ``WIDEST_MARGIN`` [m].
        """
        self.checks += 1
        data = self._data
        data.qpos[ARM] = joints
        data.qpos[FINGERS] = opening
        if self._load is not None:
            address, object_in_tool = self._load
            pose = forward(joints) @ object_in_tool
            data.qpos[address : address + 3] = pose[:3, 3]
            mujoco.mju_mat2Quat(data.qpos[address + 3 : address + 7], pose[:3, :3].reshape(-1))
        mujoco.mj_kinematics(self._model, data)
        mujoco.mj_collision(self._model, data)
        if data.ncon == 0:
            return None
        pairs = data.contact.geom[: data.ncon]  # (k, 2)
        carried = self._carried[pairs].any(axis=1)
        own = self._is_robot[pairs].all(axis=1)
        limit = np.where(carried, CARRIED_OVERLAP, np.where(own, SELF_OVERLAP, clearance))
        hits = np.flatnonzero(data.contact.dist[: data.ncon] < limit)
        if len(hits) == 0:
            return None
        first, second = pairs[hits[0]]
        if self._is_robot[second] or self._carried[second]:
            first, second = second, first
        return Collision(self._labels[first], self._labels[second])

    def any_along(self, path: Iterable[Array], opening: float, clearance: float) -> bool:
        """Whether the arm would hit anything at one of these joint angles."""
        return any(self.find(joints, opening, clearance) is not None for joints in path)

    def _set_masks(self, geoms: NDArray[np.bool_], contype: int, conaffinity: int) -> None:
        geoms = geoms & self._solid
        self._model.geom_contype[geoms] = contype
        self._model.geom_conaffinity[geoms] = conaffinity
        # MuJoCo sorts out whole bodies first, by the union of their geoms' bits.
        bodies = np.unique(self._model.geom_bodyid[geoms])
        self._model.body_contype[bodies] = contype
        self._model.body_conaffinity[bodies] = conaffinity


def _robot_bodies(model: mujoco.MjModel) -> NDArray[np.bool_]:
    """Which bodies are part of the arm, shape (nbody,)."""
    root = model.body_rootid[model.body("hand").id]
    return model.body_rootid == root


def _labels(model: mujoco.MjModel, bodies: dict[str, ObjectBody]) -> list[str]:
    """What each geom is called when it is hit, one per geom."""
    names = {body.body_id: name for name, body in bodies.items()}
    robot = _robot_bodies(model)

    def label(geom: int) -> str:
        body = int(model.geom_bodyid[geom])
        if body in names:
            return names[body]
        if robot[body]:
            return "the gripper" if model.body(body).name in _HAND else "the arm"
        return f"the {model.geom(geom).name or 'table'}"

    return [label(geom) for geom in range(model.ngeom)]
