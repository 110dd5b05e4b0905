"""Handle: how the arm moves a drawer, a door or a lid that it holds by the fin.

What has a moving part is known by its model: how it stands is read from the simulator.
"""

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.arm import Arm
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import CLEARANCE, TOUCHING
from app.worlds.simulators.mujoco.rotation import about
from app.worlds.simulators.mujoco.scene_builder import ObjectBody

Array = NDArray[np.float64]

ABOVE = 0.08
"""The hand comes down onto the fin from so far above [m]."""
BRANCHES = 24
"""So many of the arm's postures over the fin are tried."""
STEP = 0.008
"""Distance of neighbouring poses along the way of the fin [m]."""
TILTS = np.radians([0, 20, -20, 35, -35])
"""How far the hand may lean away from the front of what it opens, or towards it [rad]."""
WIDE = 0.025
"""How far each finger is from the middle around the fin [m]."""
DRIFTS = np.linspace(-0.12, 0.12, 9)
"""How far a joint that is left free may turn from one pose to the next [rad]."""
LARGEST_TURN = 0.3
"""The most any joint may [rad]."""


@dataclass(frozen=True, slots=True, eq=False)
class Haul:
    """How a part is moved; joint angles, shapes (n, joints) [rad]."""

    reach: Array
    lower: Array
    along: Array
    rise: Array


class Handle:
    """The fin of one object."""

    def __init__(self, physics: Physics, body: ObjectBody) -> None:
        """Find it.

        Raises:
            ActionFailure: the object has nothing to open or close.
        """
        if body.articulation is None or body.joint is None:
            raise ActionFailure("check", f"{body.name} has no lid, door or drawer")
        self._articulation = body.articulation
        self._physics, self._name = physics, body.name
        data = physics.stand()
        self._pose = np.eye(4)
        self._pose[:3, :3] = data.xmat[body.body_id].reshape(3, 3)
        self._pose[:3, 3] = data.xpos[body.body_id]
        self._now = float(data.qpos[physics.model.jnt_qposadr[body.joint]])
        self._turned_down: Counter[str] = Counter()

    def haul(self, collisions: Collisions, goal: float, rng: np.random.Generator) -> Haul:
        """The way of the arm that brings the part to a share of its travel.

        Args:
            collisions: refreshed.
            goal: 0 for shut, 1 for wholly open.
            rng: for searching paths.

        Raises:
            ActionFailure: there is none; the reason is the commonest obstacle.
        """
        end = goal * self._articulation.travel
        way = [self._fin(q) for q in (self._now, end)]
        if self._articulation.joint == "hinge":
            length = float(np.linalg.norm(self._arm())) * abs(end - self._now)
        else:
            length = float(np.linalg.norm(way[1][0] - way[0][0]))
        count = max(2, math.ceil(length / STEP))
        for side, tilt in product((1.0, -1.0), TILTS):
            poses = [self._tool(q, side, tilt) for q in np.linspace(self._now, end, count)]
            for haul in self._hauls(poses, collisions, rng):
                return haul
        reason, _ = self._turned_down.most_common(1)[0]
        raise ActionFailure(
            "reach",
            f"the handle of {self._name} cannot be moved: {reason}",
            pose=kinematics.pose(self._tool(end, 1.0)),
        )

    def _arm(self) -> Array:
        """From the joint to the fin, in the object's frame, shape (3,) [m]."""
        return np.subtract(self._articulation.handle, self._articulation.pivot)

    def _fin(self, value: float) -> tuple[Array, Array]:
        """The fin's middle and the direction across it with the joint at a value, base frame."""
        shape, across = self._articulation, np.array([0.0, 1.0, 0.0])
        axis, place = np.array(shape.axis), np.array(shape.handle)
        if shape.joint == "slide":
            place = place + axis * value
        else:
            turn = about(axis, value)
            place = np.array(shape.pivot) + turn @ self._arm()
            across = turn @ across
        return self._pose[:3, :3] @ place + self._pose[:3, 3], self._pose[:3, :3] @ across

    def _tool(self, value: float, side: float, tilt: float = 0.0) -> Array:
        """The tool's pose that holds the fin from above, whatever it turns about lying axes.

        Args:
            value: of the joint.
            side: 1 or -1, for either finger on either side.
            tilt: how far the hand leans away from the front [rad].
        """
        place, across = self._fin(value)
        down = np.array([0.0, 0.0, -1.0])
        closing = side * (across - down * (across @ down))
        closing /= np.linalg.norm(closing)
        inward = -side * np.cross(closing, down)
        approach = np.cos(tilt) * down + np.sin(tilt) * inward
        tool = np.eye(4)
        tool[:3, :3] = np.stack([np.cross(closing, approach), closing, approach], axis=1)
        tool[:3, 3] = place
        return tool

    def _hauls(
        self, poses: list[Array], collisions: Collisions, rng: np.random.Generator
    ) -> Iterator[Haul]:
        arm, start = self._physics.arm, self._physics.joints
        above, over = poses[0].copy(), poses[-1].copy()
        above[2, 3] += ABOVE
        over[2, 3] += ABOVE
        postures = arm.inverse(above, start)[:BRANCHES]
        if len(postures) == 0:
            self._turned_down[_TOO_FAR] += 1
        for joints in postures:
            lower = arm.line(above, poses[0], joints)
            along = None if lower is None else _follow(arm, poses, lower[-1])
            rise = None if along is None else arm.line(poses[-1], over, along[-1])
            if lower is None or along is None or rise is None:
                self._turned_down[_TOO_FAR] += 1
            elif not self._hits(np.concatenate([lower, along]), collisions):
                reach = free_path(
                    arm,
                    start,
                    joints,
                    lambda q: collisions.find(q, arm.largest_opening, CLEARANCE) is not None,
                    rng,
                )
                if reach is not None:
                    yield Haul(reach, lower, along, rise)
                self._turned_down["no path free of collisions was found"] += 1

    def _hits(self, path: Array, collisions: Collisions) -> bool:
        """Whether the arm would touch anything but the object itself."""
        for joints in path:
            collision = collisions.find(joints, WIDE, TOUCHING)
            if collision and collision.second != self._name:
                self._turned_down[f"collision of {collision}"] += 1
                return True
        return False


_TOO_FAR = "the arm cannot get there"


def _follow(arm: Arm, poses: list[Array], joints: Array) -> Array | None:
    """Joint angles through neighbouring poses, shape (n, joints); None if the arm cannot follow."""
    path = [joints]
    for pose in poses[1:]:
        found = arm.inverse(pose, path[-1], DRIFTS)
        if len(found) == 0 or float(np.abs(found[0] - path[-1]).max()) > LARGEST_TURN:
            return None
        path.append(found[0])
    return np.array(path)
