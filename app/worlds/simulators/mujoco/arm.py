"""Arm: the port behind which every robot arm of the tabletop stands, its gripper included.

A pose is a homogeneous transform, shape (4, 4), of the tool frame ``tcp`` in the robot's base frame:
origin between the finger tips, x across the fingers, y along the closing direction, z the approach
direction [m]. Joint angles have shape (n,), n the number of the arm's joints [rad].
"""

import math
from abc import ABC, abstractmethod
from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.robot import RobotLimits

Array = NDArray[np.float64]

CLEARANCE = 0.03
"""How far from its limit every joint is kept [rad]."""
TOLERANCE = 1e-4
"""How far a solution's pose may be from the one asked for, in any entry of the transform."""
LINE_STEP = 0.01
"""Distance between neighbouring poses of a straight line [m]."""
MISSES = (0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5)
"""How much nearer the shoulder a pose is tried that is out of reach [m]."""
NEAR_LIMIT = 0.15
"""A joint so near its limit is said to be there [rad]."""
LARGEST_TURN = 0.25
"""The most a joint may turn from one pose of a line to the next [rad]."""


class Box(NamedTuple):
    """A part of the gripper in the tool frame, where both fingers meet [m]."""

    half: tuple[float, float, float]
    middle: tuple[float, float, float]


class Arm(ABC):
    """What there is to know of an arm with two parallel fingers.

    In the compiled model, the arm's joints come first, then the gripper's; so do the actuators.
    """

    title: str
    """As people call it."""
    home: Array
    """Drawn back, the cameras' view of the table clear [rad]."""
    lowest: Array
    highest: Array
    """What the joints turn between [rad]."""
    speed: Array
    """The joints' speeds that are made use of [rad/s]."""
    acceleration: Array
    """The joints' accelerations that are made use of [rad/s²]."""
    limits: RobotLimits
    """What the maker allows a real one; enforced on the way to it, whatever a plan says."""
    shoulder: Array
    """Around it the arm reaches about as far in every direction, base frame, shape (3,) [m]."""
    drifts: tuple[float, ...] = (0.0,)
    """Where a joint is left free: how far it may turn aside to follow a line, tried in order [rad]."""
    largest_opening: float
    """How far either finger is from the middle when the gripper is open [m]."""
    finger_joints: int
    """Of the gripper, in the model."""
    hand: str
    """Name of the body that bears the fingers."""
    fingers: tuple[str, str]
    """Names of the bodies whose touch holds an object."""
    finger: Box
    """One finger; the other is its mirror image."""
    palm: Box
    """What bears the fingers."""

    @property
    def joints(self) -> int:
        """How many the arm has, the gripper's left out."""
        return len(self.home)

    @property
    def arm_part(self) -> slice:
        """The arm's joints in ``qpos``, and its actuators in ``ctrl``."""
        return slice(0, self.joints)

    @property
    def finger_part(self) -> slice:
        """The gripper's joints in ``qpos``."""
        return slice(self.joints, self.joints + self.finger_joints)

    @abstractmethod
    def spec(self) -> mujoco.MjSpec:
        """The model, standing at the origin, freshly read; with the site ``tcp``.

        Raises:
            ModuleNotFoundError: the package that brings it is not installed.
        """
        ...

    @abstractmethod
    def finger_joints_at(self, opening: float) -> Array:
        """The gripper's joints with each finger so far from the middle [m]."""
        ...

    @abstractmethod
    def opening_at(self, finger_joints: Array) -> float:
        """How far each finger is from the middle, on average, at these joints [m]."""
        ...

    @abstractmethod
    def control_at(self, opening: float) -> float:
        """What the gripper's actuator is sent to bring each finger so far from the middle [m]."""
        ...

    @abstractmethod
    def commanded_at(self, control: float) -> float:
        """The inverse of ``control_at`` [m]."""
        ...

    @abstractmethod
    def forward(self, joints: Array) -> Array:
        """The tool's pose, shape (4, 4), with the joints at these angles."""
        ...

    @abstractmethod
    def _solutions(self, tool: Array, near: Array, drifts: Array | None) -> Array:
        """All joint angles in question, shape (n, joints); NaN and wrong ones are sorted out."""
        ...

    def inverse(self, tool: Array, near: Array, drifts: Array | None = None) -> Array:
        """The joint angles that bring the tool to a pose, the least motion from ``near`` first.

        Args:
            tool: pose of the tool, shape (4, 4).
            near: joint angles to stay close to.
            drifts: how far from where it is in ``near`` a joint may be that the pose leaves free,
                shape (k,) [rad]; None for anywhere.

        Returns:
            Solutions inside the joint limits, shape (n, joints) [rad]; n may be 0.
        """
        found = self._solutions(tool, near, drifts)
        # A comparison with NaN, "no solution", is false.
        low, high = self.lowest + CLEARANCE, self.highest - CLEARANCE
        inside = np.all((found > low) & (found < high), axis=1)
        # Next to a singularity a closed form is off by millimetres; such solutions are no use.
        found = np.array([q for q in found[inside] if self._reaches(q, tool)])
        found = found.reshape(-1, self.joints)
        apart = np.abs(found - near)  # (n, joints)
        cost = apart.max(axis=1, initial=0.0) + 0.3 * np.sqrt((apart**2).sum(axis=1))
        return found[np.argsort(cost, kind="stable")]

    def _reaches(self, joints: Array, tool: Array) -> bool:
        return bool(np.abs(self.forward(joints) - tool).max() < TOLERANCE)

    def missed(self, tool: Array, near: Array) -> str:
        """How far a pose without a solution is out of reach, and what stops the arm there.

        Args:
            tool: pose of the tool, shape (4, 4).
            near: joint angles to stay close to.
        """
        inwards = self.shoulder - tool[:3, 3]
        inwards /= np.linalg.norm(inwards)
        for distance in MISSES:
            pulled = tool.copy()
            pulled[:3, 3] += inwards * distance
            found = self.inverse(pulled, near)
            if len(found):
                spare = np.minimum(found - self.lowest, self.highest - found).min(axis=0)
                joint = int(np.argmin(spare)) + 1
                stop = f", where joint {joint} is at its limit" if spare.min() < NEAR_LIMIT else ""
                return f"it is missed by {distance:.2f} m{stop}"
        return "no joint angles turn the gripper that way around there"

    def line(self, start: Array, end: Array, joints: Array) -> Array | None:
        """Joint angles along the straight line from ``start`` to ``end``, the tool not turning.

        Args:
            start: pose where the line begins, shape (4, 4); ``end`` has the same orientation.
            end: pose where it ends, shape (4, 4).
            joints: angles at the start.

        Returns:
            Angles of poses ``LINE_STEP`` apart, shape (k, joints), or None if it cannot follow.
        """
        way = end[:3, 3] - start[:3, 3]
        count = max(1, math.ceil(float(np.linalg.norm(way)) / LINE_STEP))
        path = [joints]
        for index in range(1, count + 1):
            pose = end.copy()
            pose[:3, 3] = start[:3, 3] + way * (index / count)
            following = self._next(pose, path[-1])
            if following is None:
                return None
            path.append(following)
        return np.array(path)

    def _next(self, pose: Array, joints: Array) -> Array | None:
        """The solution next to ``joints``, a free joint turned aside a little where it must be."""
        for drift in self.drifts:
            found = self.inverse(pose, joints, np.array([drift]))
            if len(found) and float(np.abs(found[0] - joints).max()) < LARGEST_TURN:
                return found[0]
        return None
