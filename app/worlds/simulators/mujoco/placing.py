"""Placing: where a held object is put down, and the arm's way there."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.destination import Destination, Landing
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import CLEARANCE, SEARCHES, TURNS, turned

Array = NDArray[np.float64]

HOVER = 0.05
"""Lowering begins so far above the rim [m]."""
GAPS = ((0.004, 0.015), (0.03, 0.05), (0.075, 0.1))
"""Heights above the spot to let go at; a later pair only where the earlier ones cannot be reached,
since the gripper does not fit between the walls of what is deep and narrow [m]."""
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
    """Joint angles on the way to above the spot, shape (n, joints) [rad]."""
    lower: Array
    """Joint angles of the straight line down, shape (n, joints) [rad]."""
    opening: float
    """Distance of each finger from the middle at which it is let go [m]."""


Posture = tuple[Array, Array, float]
"""Joint angles, shape (joints,); the tool's pose with them; its height where the object is let go."""


class Placing:
    """Chooses how to put down what is in the gripper."""

    def __init__(self, physics: Physics, collisions: Collisions, rng: np.random.Generator) -> None:
        self._physics = physics
        self._collisions = collisions
        self._arm = collisions.arm
        self._rng = rng
        self._obstacles: Counter[str] = Counter()
        self._pathless = 0

    def check_room(self, name: str, destination: Destination) -> None:
        """See, before it is picked up, whether there is room for the object.

        Raises:
            ActionFailure: there is none.
        """
        points, middle = self._collisions.shape(name)
        destination.landings(points, middle[:2], TURNS[:6:2])

    def choose(self, name: str, destination: Destination) -> Place:
        """The best way to put it down that can be carried out.

        Raises:
            ActionFailure: there is none.
        """
        points, middle = self._collisions.shape(name)
        middle = np.append(middle[:2], points[:, 2].min())
        landings = destination.landings(points, middle[:2], TURNS)
        postures = self._postures(landings, middle, destination.rim)
        self._collisions.refresh()
        with self._collisions.carrying(name):
            for gaps in GAPS:
                for joints, hover, height in postures[:MOST]:
                    for gap in gaps:
                        # Where several ways were looked for in vain, the next ones are as blocked.
                        if self._pathless >= SEARCHES:
                            raise self._failure(name, landings, postures, middle)
                        place = self._place(joints, hover, height + gap)
                        if place is not None:
                            return place
        raise self._failure(name, landings, postures, middle)

    def _failure(
        self, name: str, landings: list[Landing], postures: list[Posture], middle: Array
    ) -> ActionFailure:
        """Why nothing will do, and where the gripper would have had to be."""
        start = self._physics.joints
        if not postures:
            hover = _over(self._arm.forward(start), middle, landings[0])
            why = f"the arm cannot hold {name} over it: {self._arm.missed(hover, start)}"
            return ActionFailure("place", why, pose=kinematics.pose(hover))
        obstacle, _ = (self._obstacles or Counter(("no path to it was found",))).most_common(1)[0]
        why = f"no way to put {name} down there is free of collisions: {obstacle}"
        return ActionFailure("place", why, pose=kinematics.pose(postures[0][1]))

    def _postures(self, landings: list[Landing], middle: Array, rim: float) -> list[Posture]:
        """Joint angles over each landing, the tool's pose there, and its height when let go."""
        start = self._physics.joints
        tool = self._arm.forward(start)
        found: list[tuple[float, Array, Array, float]] = []
        for landing in landings:
            spot = landing.spot
            hover = _over(tool, middle, landing)
            let_go = hover[2, 3]
            hover[2, 3] = let_go - spot.height + max(spot.height, rim) + HOVER
            for joints in self._arm.inverse(hover, start)[:2]:
                cost = spot.cost + MOTION_COST * float(np.abs(joints - start).max())
                found.append((cost, joints, hover, let_go))
        found.sort(key=lambda entry: entry[0])
        return [(joints, hover, let_go) for _, joints, hover, let_go in found]

    def _place(self, joints: Array, hover: Array, height: float) -> Place | None:
        opening = self._physics.opening
        if self._hits([joints], opening, CLEARANCE):
            return None
        bottom = hover.copy()
        bottom[2, 3] = height
        lower = self._arm.line(hover, bottom, joints)
        if lower is None:
            self._obstacles["the arm cannot get down there"] += 1
            return None
        if self._hits(lower[1:], opening, LOWERING):
            return None
        carry = free_path(
            self._arm,
            self._physics.joints,
            joints,
            lambda q: self._collisions.find(q, opening, CLEARANCE) is not None,
            self._rng,
        )
        if carry is None:
            self._pathless += 1
            return None
        return Place(carry, lower, self._let_go(lower[-1]))

    def _hits(self, path: Iterable[Array], opening: float, clearance: float) -> bool:
        collision = self._collisions.first_along(path, opening, clearance)
        if collision is not None:
            self._obstacles[str(collision)] += 1
        return collision is not None

    def _let_go(self, joints: Array) -> float:
        """How far the fingers can open there [m]."""
        held = self._physics.opening
        for opening in [opening for opening in OPENINGS if opening > held + 0.003]:
            if self._collisions.find(joints, opening, 0.0) is None:
                return opening
        return min(OPENINGS[0], held + 0.012)


def _over(tool: Array, middle: Array, landing: Landing) -> Array:
    """The tool's pose where the held object rests on a spot, turned as it is to be."""
    leant = tool.copy()
    leant[:3, :3] = landing.lean @ tool[:3, :3]
    leant[:3, 3] = middle + landing.lean @ (tool[:3, 3] - middle)
    pose = turned(leant, middle, landing.turn)
    spot = landing.spot
    pose[:3, 3] += np.array([spot.x, spot.y, spot.height + landing.sunk]) - middle
    return pose
