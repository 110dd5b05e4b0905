"""Placing: where a held object is put down, and the arm's way there."""

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.collision import Carried, Collisions
from app.worlds.simulators.mujoco.destination import Destination, Landing
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import CLEARANCE, TURNS, turned
from app.worlds.simulators.mujoco.surface import surface_points

Array = NDArray[np.float64]

HOVER = 0.05
"""Lowering begins so far above the rim [m]."""
GAPS = ((0.004, 0.015), (0.03, 0.05))
"""Heights above the spot to let go at; the second pair only where the first cannot be reached [m]."""
MOST = 24
"""So many landings are examined."""
LOWERING = 0.001
"""Clearance of the gripper while lowering [m]."""
OPENINGS = (0.04, 0.03, 0.022, 0.015, 0.01)
"""How far each finger may open to let go, as far as there is space [m]."""
MOTION_COST = 0.01
"""What a radian of the joint that moves most costs, in metres of height [m/rad]."""


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """How a held object is put down."""

    carry: Array
    """Joint angles on the way to above the spot, shape (n, 7) [rad]."""
    lower: Array
    """Joint angles of the straight line down, shape (n, 7) [rad]."""
    opening: float
    """Distance of each finger from the middle at which it is let go [m]."""


class Placing:
    """Chooses how to put down what is in the gripper."""

    def __init__(self, physics: Physics, collisions: Collisions, rng: np.random.Generator) -> None:
        self._physics = physics
        self._collisions = collisions
        self._rng = rng

    def carried(self, name: str) -> Carried:
        """The object as it is in the gripper now."""
        data = self._physics.stand()
        body = self._physics.bodies[name].body_id
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = data.xmat[body].reshape(3, 3), data.xpos[body]
        return Carried(name, np.linalg.inv(kinematics.forward(self._physics.joints)) @ pose)

    def check_room(self, name: str, destination: Destination) -> None:
        """See, before it is picked up, whether there is room for the object.

        Raises:
            ActionFailure: there is none.
        """
        points, middle = self._shape(name)
        destination.landings(points, middle[:2], TURNS[:6:2])

    def choose(self, name: str, destination: Destination) -> Place:
        """The best way to put it down that can be carried out.

        Raises:
            ActionFailure: there is none.
        """
        points, middle = self._shape(name)
        middle[2] = points[:, 2].min()
        landings = destination.landings(points, middle[:2], TURNS)
        postures = self._postures(landings, middle, destination.rim)
        self._collisions.refresh()
        with self._collisions.carrying(self.carried(name)):
            for gaps in GAPS:
                for joints, hover, height in postures[:MOST]:
                    for gap in gaps:
                        place = self._place(joints, hover, height + gap)
                        if place is not None:
                            return place
        reason = f"no way to put {name} down there is free of collisions" if postures else (
            f"the arm cannot hold {name} over it"
        )  # fmt: skip
        raise ActionFailure("place", reason)

    def _shape(self, name: str) -> tuple[Array, Array]:
        """Surface points, shape (n, 3), and the middle, shape (3,), base frame [m]."""
        data = self._physics.stand()
        body = self._physics.bodies[name].body_id
        mujoco.mj_comPos(self._physics.model, data)
        points = surface_points(self._physics.model, data, body)
        box = (points.min(axis=0) + points.max(axis=0)) / 2
        return points, (box + data.xipos[body]) / 2

    def _postures(
        self, landings: list[Landing], middle: Array, rim: float
    ) -> list[tuple[Array, Array, float]]:
        """Joint angles over each landing, the tool's pose there, and its height when let go."""
        start = self._physics.joints
        tool = kinematics.forward(start)
        found: list[tuple[float, Array, Array, float]] = []
        for landing in landings:
            spot = landing.spot
            hover = turned(tool, middle, landing.turn)
            hover[:2, 3] += np.array([spot.x, spot.y]) - middle[:2]
            let_go = hover[2, 3] - middle[2] + spot.height
            hover[2, 3] = let_go - spot.height + max(spot.height, rim) + HOVER
            for joints in kinematics.inverse(hover, start)[:2]:
                cost = spot.cost + MOTION_COST * float(np.abs(joints - start).max())
                found.append((cost, joints, hover, let_go))
        found.sort(key=lambda entry: entry[0])
        return [(joints, hover, let_go) for _, joints, hover, let_go in found]

    def _place(self, joints: Array, hover: Array, height: float) -> Place | None:
        opening = self._physics.opening
        if self._collisions.find(joints, opening, CLEARANCE) is not None:
            return None
        bottom = hover.copy()
        bottom[2, 3] = height
        lower = kinematics.line(hover, bottom, joints)
        if lower is None or self._collisions.any_along(lower[1:], opening, LOWERING):
            return None
        carry = free_path(
            self._physics.joints,
            joints,
            lambda q: self._collisions.find(q, opening, CLEARANCE) is not None,
            self._rng,
        )
        if carry is None:
            return None
        return Place(carry, lower, self._let_go(lower[-1]))

    def _let_go(self, joints: Array) -> float:
        """How far the fingers can open there [m]."""
        held = self._physics.opening
        for opening in [opening for opening in OPENINGS if opening > held + 0.003]:
            if self._collisions.find(joints, opening, 0.0) is None:
                return opening
        return min(OPENINGS[0], held + 0.012)
