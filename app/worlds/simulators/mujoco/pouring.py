"""Pouring: how a held vessel is brought over a place and tilted there, its lip staying over it."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.level import Level
from app.worlds.simulators.mujoco.motion import Blocked, free_path
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import BRANCHES, CLEARANCE
from app.worlds.simulators.mujoco.righting import onto_vertical, up_axis

Array = NDArray[np.float64]

TILTS = np.radians(np.arange(0, 111, 5))
"""On the way from upright to emptied [rad]."""
TOWARDS = np.radians(np.arange(0, 360, 20))
"""Where the lip may point [rad]."""
EMPTIED = np.radians(100)
"""From this tilt on nothing stays inside, even where walls taper [rad]."""
SHORT = (0.0, 0.025)
"""How far before the middle of the target's mouth the lip may be; what runs out flies on [m]."""
ABOVE = (0.03, 0.05, 0.08)
"""Between the target's rim and the lowest of the vessel [m]."""
LARGEST_TURN = 0.45
"""The most a joint may turn from one tilt to the next [rad]."""


@dataclass(frozen=True, slots=True, eq=False)
class Poured:
    """How a vessel is emptied; joint angles, shapes (n, joints) [rad]."""

    carry: Array
    tilt: Array


class Pouring:
    """Chooses how to empty what is in the gripper."""

    def __init__(self, physics: Physics, collisions: Collisions, rng: np.random.Generator) -> None:
        self._physics = physics
        self._collisions = collisions
        self._arm = collisions.arm
        self._rng = rng

    def choose(self, name: str, over: Array) -> Poured:
        """The first way that can be carried out.

        Args:
            name: what is held, its mouth up.
            over: the middle of the target's mouth, shape (3,), base frame [m].

        Raises:
            ActionFailure: there is none.
        """
        body = self._physics.bodies[name]
        data = self._physics.stand()
        assert body.opening is not None
        radius, rim = body.opening.radius, body.opening.rim
        foot = data.xpos[body.body_id].copy()
        start, opening = self._physics.joints, self._physics.opening
        # A grasp that slants leaves it leaning in the gripper: pouring begins once it stands.
        upright = onto_vertical(up_axis(self._physics, name))
        tool = self._arm.forward(start)
        tool[:3, :3] = upright @ tool[:3, :3]
        tool[:3, 3] = foot + upright @ (tool[:3, 3] - foot)
        level = Level(self._physics, name)
        self._collisions.refresh()

        def blocked(joints: Array) -> bool:
            return self._collisions.find(joints, opening, CLEARANCE) is not None

        def spilling(joints: Array) -> bool:
            return level.lost(joints) or blocked(joints)

        with self._collisions.carrying(name):
            for gap, short, towards in product(ABOVE, SHORT, TOWARDS):
                ahead = np.array([np.cos(towards), np.sin(towards), 0.0])
                lip = foot + radius * ahead + (0.0, 0.0, rim)
                place = over - short * ahead + (0.0, 0.0, gap)
                poses = [_tilted(tool, lip, ahead, tilt) for tilt in TILTS]
                for pose, tilt in zip(poses, TILTS, strict=True):
                    pose[:3, 3] += place
                    pose[2, 3] += rim * max(0.0, float(np.cos(tilt)))
                for path in self._paths(poses, start, blocked):
                    carry = free_path(self._arm, start, path[0], spilling, self._rng)
                    if carry is not None:
                        return Poured(carry, path)
        raise ActionFailure("pour", f"no way to tilt {name} over there was found")

    def _paths(self, poses: list[Array], start: Array, blocked: Blocked) -> Iterator[Array]:
        """Joint angles through the poses, shapes (n, joints), that are free of collisions."""
        for joints in self._arm.inverse(poses[0], start)[:BRANCHES]:
            path = self._followed(poses, joints)
            if path is not None and not any(map(blocked, path)):
                yield path

    def _followed(self, poses: list[Array], joints: Array) -> Array | None:
        path = [joints]
        for pose in poses[1:]:
            found = self._arm.inverse(pose, path[-1])
            if len(found) == 0 or np.abs(found[0] - path[-1]).max() > LARGEST_TURN:
                break
            path.append(found[0])
        return np.array(path) if TILTS[len(path) - 1] >= EMPTIED else None


def _tilted(tool: Array, lip: Array, ahead: Array, tilt: float) -> Array:
    """The tool's pose relative to the lip, shape (4, 4), once the vessel leans ahead [rad]."""
    up = np.array([0.0, 0.0, 1.0])
    aside = np.cross(up, ahead)
    base = np.column_stack([ahead, aside, up])
    cosine, sine = np.cos(tilt), np.sin(tilt)
    lean = base @ np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]]) @ base.T
    pose = np.eye(4)
    pose[:3, :3] = lean @ tool[:3, :3]
    pose[:3, 3] = lean @ (tool[:3, 3] - lip)
    return pose
