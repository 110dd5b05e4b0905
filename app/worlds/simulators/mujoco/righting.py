"""Righting: how a held object that lies on its side is turned up and put down on its foot."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.destination import Destination
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import BRANCHES, CLEARANCE, turned

Array = NDArray[np.float64]

TURNS = np.radians(np.arange(0, 360, 20))
"""About the vertical, once it is upright [rad]."""
HOVER = 0.06
"""Lowering begins so far above the table [m]."""
GAPS = (0.004, 0.012, 0.03)
"""Heights above the table to let go at [m]."""
STEEPEST = 0.35
"""The hand may point up by this much where the object is let go; the sine."""
BACK = 0.07
"""The open hand is drawn back so far [m]."""
LOWERING = 0.001
"""Clearance while lowering [m]."""
RELEASE = 0.038
"""How far each finger opens to let go [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class Righted:
    """How an object is put down upright; joint angles, shapes (n, joints) [rad]."""

    carry: Array
    lower: Array
    back: Array


def up_axis(physics: Physics, name: str) -> Array:
    """Where the top of an object points, base frame, shape (3,); read from the simulator."""
    body = physics.bodies[name].body_id
    return physics.stand().xmat[body].reshape(3, 3)[:, 2].copy()


class Righting:
    """Chooses how to put down what is in the gripper upright."""

    def __init__(self, physics: Physics, collisions: Collisions, rng: np.random.Generator) -> None:
        self._physics = physics
        self._collisions = collisions
        self._arm = collisions.arm
        self._rng = rng

    def choose(self, name: str, room: Destination) -> Righted:
        """The first way that can be carried out.

        Args:
            name: what is held.
            room: free places on the table.

        Raises:
            ActionFailure: there is none.
        """
        points, middle = self._collisions.shape(name)
        rotation = onto_vertical(up_axis(self._physics, name))
        upright = (points - middle) @ rotation.T
        tool = self._arm.forward(self._physics.joints)
        stood = np.eye(4)
        stood[:3, :3] = rotation @ tool[:3, :3]
        stood[:3, 3] = rotation @ (tool[:3, 3] - middle)
        low = -float(upright[:, 2].min())
        landings = room.landings(upright, np.zeros(2), np.zeros(1))
        spots = [np.array([each.spot.x, each.spot.y, low]) for each in landings]
        self._collisions.refresh()
        with self._collisions.carrying(name):
            for spot, turn in [(spot, turn) for spot in spots for turn in TURNS]:
                pose = turned(stood, np.zeros(3), turn)
                pose[:3, 3] += spot
                if pose[2, 2] < STEEPEST:
                    for found in self._ways(pose):
                        return found
        stood[:3, 3] += spots[0]
        raise ActionFailure(
            "place",
            f"no way to put {name} down upright was found",
            pose=kinematics.pose(stood),
        )

    def _ways(self, pose: Array) -> Iterator[Righted]:
        opening, start = self._physics.opening, self._physics.joints
        hover = pose.copy()
        hover[2, 3] += HOVER
        for joints in self._arm.inverse(hover, start)[:BRANCHES]:
            if self._collisions.find(joints, opening, CLEARANCE) is not None:
                continue
            for gap in GAPS:
                bottom, away = pose.copy(), pose.copy()
                bottom[2, 3] += gap
                away[:3, 3] = bottom[:3, 3] - BACK * pose[:3, 2]
                lower = self._arm.line(hover, bottom, joints)
                back = None if lower is None else self._arm.line(bottom, away, lower[-1])
                if lower is None or back is None:
                    continue
                if self._collisions.any_along(lower[1:], opening, LOWERING):
                    continue
                carry = free_path(
                    self._arm,
                    start,
                    joints,
                    lambda q: self._collisions.find(q, opening, CLEARANCE) is not None,
                    self._rng,
                )
                if carry is not None:
                    yield Righted(carry, lower, back)


def onto_vertical(axis: Array) -> Array:
    """The least rotation that turns an axis up, shape (3, 3)."""
    up = np.array([0.0, 0.0, 1.0])
    cross = np.cross(axis, up)
    sine, cosine = float(np.linalg.norm(cross)), float(axis @ up)
    if sine < 1e-6:
        return np.eye(3) if cosine > 0 else np.diag([1.0, -1.0, -1.0])
    x, y, z = cross / sine
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + sine * skew + (1 - cosine) * (skew @ skew)
