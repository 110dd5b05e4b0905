"""Pushing: a stroke of the finger tips that shoves an object over the table."""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.picking import BRANCHES, CLEARANCE, TOUCHING

Array = NDArray[np.float64]

TILTS = np.radians([0, 20, 40, 55])
"""How far the fingers may lean forward [rad]."""
TALL_TILTS = np.radians([40, 55, 20, 0])
"""The same for a tall object, which the hand must stay behind: pushed high up, it would topple."""
PALM = 0.035
"""The palm is so far above the finger tips [m]."""
LOWEST_TIP = 0.0105
"""Of the point between the finger tips above the table [m]."""
CONTACT = (0.4, 0.035)
"""Where an object is pushed: this share of its height, at most so high [m]."""
SPREAD = 0.3
"""Half the distance of the fingers as a share of the object's width; two fingers steer it."""
WIDEST = 0.038
"""The most each finger is from the middle [m]."""
BEHIND = 0.032
"""The stroke begins so far behind the object [m]."""
FINGER = 0.011
"""Half a finger's thickness in the direction of the stroke [m]."""
LOWERING = 0.10
"""The hand comes down from so far above [m]."""
BESIDE = 0.012
"""To be free to either side of the object's way [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class Push:
    """How an object is pushed; joint angles, shapes (n, joints) [rad]."""

    opening: float
    """Distance of each finger from the middle [m]."""
    reach: Array
    lower: Array
    stroke: Array
    rise: Array


class Pushing:
    """Chooses a push."""

    def __init__(self, collisions: Collisions, start: Array, rng: np.random.Generator) -> None:
        """Prepare.

        Args:
            collisions: refreshed, that is knowing where the objects stand.
            start: the arm's joint angles now, shape (joints,) [rad].
            rng: for searching paths.
        """
        self._collisions = collisions
        self._arm = collisions.arm
        self._start = start
        self._rng = rng
        self._turned_down: Counter[str] = Counter()

    def choose(
        self, name: str, clouds: Mapping[str, Cloud], towards: Array, distance: float
    ) -> Push:
        """A push that can be carried out.

        Args:
            name: the object.
            clouds: everything seen.
            towards: unit vector in the plane of the table, shape (2,).
            distance: how far [m].

        Raises:
            ActionFailure: there is none; the reason is the commonest obstacle.
        """
        cloud = clouds[name]
        self._check_way(name, clouds, towards, distance)
        first: Array | None = None
        with self._collisions.grasping(name, cloud):
            for tool, opening in _tools(cloud, towards):
                first = tool if first is None else first
                for push in self._pushes(name, tool, opening, np.append(towards, 0.0), distance):
                    return push
        reason, _ = self._turned_down.most_common(1)[0]
        raise ActionFailure(
            "reach",
            f"{name} cannot be pushed that way: {reason}",
            pose=None if first is None else kinematics.pose(first),
        )

    def _check_way(
        self, name: str, clouds: Mapping[str, Cloud], towards: Array, distance: float
    ) -> None:
        """Nothing stands where the object will come to."""
        across = np.array([-towards[1], towards[0]])
        own = clouds[name].points[:, :2]
        front, side = float((own @ towards).max()), own @ across
        low, high = float(side.min()) - BESIDE, float(side.max()) + BESIDE
        for other, cloud in clouds.items():
            ahead, aside = cloud.points[:, :2] @ towards, cloud.points[:, :2] @ across
            there = (ahead > front) & (ahead < front + distance + BESIDE)
            if other != name and (there & (aside > low) & (aside < high)).sum() > 2:
                raise ActionFailure("place", f"{other} is in the way of {name}")

    def _pushes(
        self, name: str, tool: Array, opening: float, towards: Array, distance: float
    ) -> Iterator[Push]:
        above, end = tool.copy(), tool.copy()
        above[2, 3] += LOWERING
        end[:3, 3] += towards * (BEHIND - FINGER + distance)
        over = end.copy()
        over[2, 3] += LOWERING
        postures = self._arm.inverse(above, self._start)[:BRANCHES]
        if len(postures) == 0:
            self._turned_down[_TOO_FAR] += 1
        for joints in postures:
            lower = self._arm.line(above, tool, joints)
            stroke = None if lower is None else self._arm.line(tool, end, lower[-1])
            rise = None if stroke is None else self._arm.line(end, over, stroke[-1])
            if lower is None or stroke is None or rise is None:
                self._turned_down[_TOO_FAR] += 1
            elif self._hits(name, lower, stroke, opening):
                continue
            elif (reach := self._reach(joints, opening)) is not None:
                yield Push(opening, reach, lower, stroke, rise)

    def _hits(self, name: str, lower: Array, stroke: Array, opening: float) -> bool:
        """Whether the arm would touch anything but, during the stroke, the object itself."""
        for path, meant in ((lower, ""), (stroke, name)):
            for joints in path:
                collision = self._collisions.find(joints, opening, TOUCHING)
                if collision and collision.second != meant:
                    self._turned_down[f"collision of {collision}"] += 1
                    return True
        return False

    def _reach(self, joints: Array, opening: float) -> Array | None:
        path = free_path(
            self._arm,
            self._start,
            joints,
            lambda q: self._collisions.find(q, opening, CLEARANCE) is not None,
            self._rng,
        )
        if path is None:
            self._turned_down["no path free of collisions was found"] += 1
        return path


_TOO_FAR = "the arm cannot get there"


def _tools(cloud: Cloud, towards: Array) -> Iterator[tuple[Array, float]]:
    """Poses of the tool behind the object, shape (4, 4), and how far the fingers are apart."""
    ahead = np.append(towards, 0.0)
    across = np.array([-towards[1], towards[0], 0.0])
    points = cloud.points
    height = float(cloud.highest[2])
    share, highest = CONTACT
    tip = max(LOWEST_TIP, min(share * height, highest))
    low = points[points[:, 2] < max(2 * tip, 0.03)]
    low = low if len(low) > 3 else points
    side, along = low @ across, low @ ahead
    middle = float(side.min() + side.max()) / 2
    opening = min(WIDEST, SPREAD * float(np.ptp(side)))
    place = across * middle + ahead * (float(along.min()) - BEHIND)
    place[2] = tip
    for tilt in TALL_TILTS if height > tip + PALM else TILTS:
        approach = np.sin(tilt) * ahead - np.cos(tilt) * np.array([0.0, 0.0, 1.0])
        for closing in (across, -across):
            tool = np.eye(4)
            tool[:3, :3] = np.stack([np.cross(closing, approach), closing, approach], axis=1)
            tool[:3, 3] = place
            yield tool, opening
