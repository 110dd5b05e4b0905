"""Picking: a grasp of an object, and the arm's way to it, chosen before anything moves."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.grasp import (
    FLAT,
    SLANTED,
    STEEP,
    Grasp,
    candidates,
    distinct,
)
from app.worlds.simulators.mujoco.motion import free_path

Array = NDArray[np.float64]

GOOD = 0.75
"""A grasp from straight above of this quality is taken without looking for slanted ones."""
MOST = 120
"""So many grasps are examined before the object counts as out of reach."""
SEARCHES = 4
"""After so many fruitless searches for a path, the object counts as walled in."""
BACK_OFF = 0.09
"""The approach begins this far from the grasp [m]."""
LIFT = 0.12
"""How far the object is lifted [m]."""
PLAY = 0.015
"""Where the gripper cannot open wholly, each finger leaves this much beside the object [m]."""
TOUCHING = 0.0005
"""Clearance close to the object [m]."""
CLEARANCE = 0.003
"""Clearance on the way there [m]."""
TURNS = np.radians([0, 30, -30, 60, -60, 90, -90, 120, -120, 150, -150, 180])
"""How the object may be turned about the vertical between taking it and putting it down [rad]."""
BRANCHES = 4
"""So many of the arm's postures are tried for one pose of the tool."""


@dataclass(frozen=True, slots=True, eq=False)
class Pick:
    """How an object is taken."""

    grasp: Grasp
    opening: float
    """Distance of each finger from the middle during the approach [m]."""
    reach: Array
    """Joint angles on the way to where the approach begins, shape (n, joints) [rad]."""
    approach: Array
    """Joint angles of the straight line to the grasp, shape (n, joints) [rad]."""
    lift: Array
    """Joint angles of the straight line upwards, shape (n, joints) [rad]."""


class Picking:
    """Chooses a pick; counts why candidates were turned down, to say so if none is left."""

    def __init__(
        self, collisions: Collisions, start: Array, destination: Array, rng: np.random.Generator
    ) -> None:
        """Prepare.

        Args:
            collisions: refreshed, that is knowing where the objects stand.
            start: the arm's joint angles now, shape (joints,) [rad].
            destination: where the object is to go, shape (3,), base frame [m].
            rng: for thinning clouds and searching paths.
        """
        self._collisions = collisions
        self._arm = collisions.arm
        self._start = start
        self._destination = destination
        self._rng = rng
        self._turned_down: Counter[str] = Counter()
        self._examples: dict[str, Array] = {}
        """For each reason, the tool's pose that was first turned down for it."""

    def choose(self, name: str, cloud: Cloud, banned: Sequence[Grasp]) -> Pick:
        """The best pick that can be carried out.

        Args:
            name: the object, as its client calls it.
            cloud: its surface.
            banned: grasps that have failed before.

        Raises:
            ActionFailure: there is none; the reason is the commonest obstacle.
        """
        with self._collisions.grasping(name, cloud):
            return self._choose(name, cloud, banned)

    def _choose(self, name: str, cloud: Cloud, banned: Sequence[Grasp]) -> Pick:
        examined = 0
        for grasps in self._tiers(cloud):
            allowed = [g for g in grasps if not any(g.like(other, 0.015) for other in banned)]
            for grasp in distinct(allowed, MOST):
                examined += 1
                if self._turned_down[_NO_PATH] >= SEARCHES:
                    raise self._failure(name, examined)
                for pick in self._picks(grasp, cloud):
                    return pick
        raise self._failure(name, examined)

    def _tiers(self, cloud: Cloud) -> Iterator[list[Grasp]]:
        """Good grasps from above first, since they are quickly found; then every grasp."""
        steep = candidates(cloud, STEEP, self._rng)
        yield [grasp for grasp in steep if grasp.quality > GOOD]
        slanted = candidates(cloud, SLANTED, self._rng)
        yield [grasp for grasp in slanted if grasp.quality > GOOD]
        others = [*steep, *slanted, *candidates(cloud, FLAT, self._rng)]
        yield sorted(others, key=lambda grasp: -grasp.score)

    def _failure(self, name: str, examined: int) -> ActionFailure:
        if examined == 0:
            return ActionFailure("grasp", f"no grasp found: nothing of {name} fits the gripper")
        reason, _ = self._turned_down.most_common(1)[0]
        stage, tool = "reach", self._examples[reason]
        if reason == _TOO_FAR:
            stage, reason = "unreachable", f"{reason}: {self._arm.missed(tool, self._start)}"
        return ActionFailure(
            stage, f"no grasp of {name} can be reached: {reason}", pose=kinematics.pose(tool)
        )

    def _turn_down(self, reason: str, tool: Array) -> None:
        self._turned_down[reason] += 1
        self._examples.setdefault(reason, tool)

    def _picks(self, grasp: Grasp, cloud: Cloud) -> Iterator[Pick]:
        """The ways to carry out a grasp, either finger on either side."""
        widest = min(self._arm.largest_opening, grasp.width / 2 + PLAY)
        for side in (1.0, -1.0):
            tool = grasp.tool.copy()
            tool[:3, :2] *= side
            postures = self._arm.inverse(tool, self._start)[:BRANCHES]
            if len(postures) == 0:
                self._turn_down(_TOO_FAR, tool)
            for joints in postures:
                pick = self._pick(grasp, tool, joints, (self._arm.largest_opening, widest), cloud)
                if pick is not None:
                    yield pick

    def _pick(
        self, grasp: Grasp, tool: Array, joints: Array, openings: Sequence[float], cloud: Cloud
    ) -> Pick | None:
        opening = self._opening(tool, joints, openings)
        if opening is None:
            return None
        before = tool.copy()
        before[:3, 3] -= tool[:3, 2] * BACK_OFF
        approach = self._line(tool, before, joints)
        above = tool.copy()
        above[2, 3] += LIFT
        lift = self._line(tool, above, joints)
        if approach is None or lift is None:
            return None
        collision = self._collisions.first_along(approach[1:], opening, TOUCHING)
        if collision is not None:
            self._turn_down(f"collision of {collision} on the way to it", tool)
            return None
        if not self._can_put_down(tool, lift[-1], cloud):
            self._turn_down("held that way it could not be put down there", tool)
            return None
        reach = free_path(
            self._arm,
            self._start,
            approach[-1],
            lambda q: self._collisions.find(q, opening, CLEARANCE) is not None,
            self._rng,
        )
        if reach is None:
            self._turn_down(_NO_PATH, tool)
            return None
        return Pick(grasp, opening, reach, approach[::-1], lift)

    def _opening(self, tool: Array, joints: Array, openings: Sequence[float]) -> float | None:
        for opening in openings:
            collision = self._collisions.find(joints, opening, TOUCHING)
            if collision is None:
                return opening
        self._turn_down(f"collision of {collision}", tool)  # pyright: ignore[reportPossiblyUnboundVariable]
        return None

    def _line(self, start: Array, end: Array, joints: Array) -> Array | None:
        path = self._arm.line(start, end, joints)
        if path is None:
            self._turn_down(_TOO_FAR, end)
        return path

    def _can_put_down(self, tool: Array, lifted: Array, cloud: Cloud) -> bool:
        """Whether the arm could hold the object over its destination, turned somehow."""
        middle = (cloud.lowest + cloud.highest) / 2
        bottom = cloud.lowest[2]
        for angle in TURNS:
            over = turned(tool, middle, angle)
            over[:2, 3] += self._destination[:2] - middle[:2]
            over[2, 3] += self._destination[2] - bottom + 0.06
            if len(self._arm.inverse(over, lifted)):
                return True
        return False


_TOO_FAR = "the arm cannot get there"
_NO_PATH = "no path free of collisions was found"


def turned(pose: Array, centre: Array, angle: float) -> Array:
    """A pose, shape (4, 4), turned about the vertical through ``centre`` by an angle [rad]."""
    cosine, sine = np.cos(angle), np.sin(angle)
    rotation = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    result = pose.copy()
    result[:3, :3] = rotation @ pose[:3, :3]
    result[:3, 3] = centre + rotation @ (pose[:3, 3] - centre)
    return result
