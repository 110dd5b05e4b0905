"""Collision checks of the arm, and of what it carries, against everything else."""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from contextlib import AbstractContextManager
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.arm import Arm
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.solid import VISUAL_GROUP

Array = NDArray[np.float64]

WIDEST_MARGIN = 0.006
"""Gaps of the arm up to this are measured; a clearance can be no larger [m]."""
SELF_OVERLAP = -0.001
CARRIED_OVERLAP = -0.0015
"""Overlaps up to this are contact, not collision: of the arm's own links, of what is carried [m]."""
OBSTACLE, ROBOT, CARRIED = 1, 2, 4
"""Bits of ``contype``. Obstacles ask for no contact, so they are never tested with each other."""
_MEETS = {OBSTACLE: 0, ROBOT: OBSTACLE | ROBOT, CARRIED: OBSTACLE}


@dataclass(frozen=True, slots=True)
class Collision:
    """Two things that would hit one another, called as the client calls them."""

    first: str
    second: str

    def __str__(self) -> str:
        return f"{self.first} with {self.second}"


class Collisions(ABC):
    """Would the arm hit something? Asked of a model of its own, never of the physics.

    ``refresh`` takes over where the objects stand now, as far as they are known.
    """

    def __init__(self, model: mujoco.MjModel, arm: Arm) -> None:
        """Prepare.

        Args:
            arm: which arm it is of.
            model: of the arm and its surroundings; what of it may touch what is set here.
        """
        self.arm = arm
        self._model = model
        self._data = mujoco.MjData(model)
        robot = robot_bodies(model, arm)
        self._hand = int(model.body(arm.hand).id)
        self._is_robot = robot[model.geom_bodyid]
        self._solid = (model.geom_contype != 0) | (model.geom_conaffinity != 0)
        # Beads touch, but nothing need keep clear of them.
        self._solid &= model.geom_group != VISUAL_GROUP
        model.geom_contype[~self._solid] = model.geom_conaffinity[~self._solid] = 0
        self._carried = np.zeros(model.ngeom, bool)
        self._set_masks(self._is_robot, ROBOT)
        self._set_masks(~self._is_robot, OBSTACLE)
        model.geom_margin[:] = np.where(self._is_robot, WIDEST_MARGIN, 0.0)
        model.geom_gap[:] = 0.0
        model.body_margin[:] = np.where(robot, WIDEST_MARGIN, 0.0)
        self.checks = 0

    @abstractmethod
    def refresh(self) -> None:
        """Take over where the objects are now."""
        ...

    @abstractmethod
    def recall(self) -> None:
        """Take over where the objects were when they were last looked at in this action."""
        ...

    @abstractmethod
    def carrying(self, name: str) -> AbstractContextManager[None]:
        """Within this, the object moves with the hand and is itself tested against obstacles."""
        ...

    @abstractmethod
    def grasping(self, name: str, cloud: Cloud) -> AbstractContextManager[None]:
        """Within this, the object is about to be taken and may come close to the fingers."""
        ...

    @abstractmethod
    def shape(self, name: str) -> tuple[Array, Array]:
        """The object as it is now.

        Returns:
            Points of its surface, shape (n, 3), and its middle, shape (3,), base frame [m].
        """
        ...

    def find(self, joints: Array, opening: float, clearance: float) -> Collision | None:
        """The first collision of the arm at these joint angles, or None.

        Args:
            joints: the arm's joint angles, shape (n,) [rad].
            opening: distance of each finger from the middle [m].
            clearance: the gap to keep from obstacles, up to ``WIDEST_MARGIN`` [m].
        """
        self.checks += 1
        data = self._data
        data.qpos[self.arm.arm_part] = joints
        data.qpos[self.arm.finger_part] = self.arm.finger_joints_at(opening)
        self._bring_along(joints)
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
        first, second = pairs[hits[0]].tolist()
        if self._is_robot[second] or self._carried[second]:
            first, second = second, first
        place = data.contact.pos[hits[0]]
        return Collision(self._label(first, place), self._label(second, place))

    def any_along(self, path: Iterable[Array], opening: float, clearance: float) -> bool:
        """Whether the arm would hit anything at one of these joint angles."""
        return self.first_along(path, opening, clearance) is not None

    def first_along(
        self, path: Iterable[Array], opening: float, clearance: float
    ) -> Collision | None:
        """The first collision of the arm at one of these joint angles, or None."""
        found = (self.find(joints, opening, clearance) for joints in path)
        return next((collision for collision in found if collision is not None), None)

    @abstractmethod
    def _bring_along(self, joints: Array) -> None:
        """Put what is carried where the hand takes it."""
        ...

    @abstractmethod
    def _label(self, geom: int, place: Array) -> str:
        """What a geom is called that was hit at a place, base frame, shape (3,) [m]."""
        ...

    def _robot_label(self, geom: int) -> str:
        # Bodies are numbered from the base on: the hand's own come last.
        return "the gripper" if self._model.geom_bodyid[geom] >= self._hand else "the arm"

    def _set_masks(self, geoms: NDArray[np.bool_], contype: int) -> None:
        geoms = geoms & self._solid
        self._model.geom_contype[geoms] = contype
        self._model.geom_conaffinity[geoms] = _MEETS[contype]
        # MuJoCo sorts out whole bodies first, by the union of their geoms' bits.
        bodies = np.unique(self._model.geom_bodyid[geoms])
        self._model.body_contype[bodies] = contype
        self._model.body_conaffinity[bodies] = _MEETS[contype]


def robot_bodies(model: mujoco.MjModel, arm: Arm) -> NDArray[np.bool_]:
    """Which bodies are part of the arm, shape (nbody,)."""
    root = model.body_rootid[model.body(arm.hand).id]
    return model.body_rootid == root
