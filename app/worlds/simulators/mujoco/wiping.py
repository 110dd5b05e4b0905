"""Wiping: how what is held is drawn over the level top of an object, in rows side by side."""

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco import kinematics
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.patch import Mask, Patch, SeenLevel
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import BRANCHES, CLEARANCE, turned
from app.worlds.simulators.mujoco.rectangle import Rectangle

Array = NDArray[np.float64]

HOVER = 0.05
"""Lowering begins so far above all of the object [m]."""
NEAR = 0.006
"""It is lowered to so far above the level; the rest of the way down it must feel [m]."""
GAP = 0.001
"""Between the level and what is held, where the rows are planned [m]."""
GRAZING = 0.0
"""Clearance of the gripper from what is wiped [m]."""
STEP = 0.006
"""By such steps a row is made longer, as far as nothing is in the way [m]."""
SPARE = 0.004
"""It stops so far short of what is in the way [m]."""
SHORTEST = 0.012
"""So far to either side it is drawn, even where one touch would cover everything [m]."""
ROWS = 3
"""Rows side by side, at most."""
ENOUGH = 0.85
"""Once this share of the level is covered, nothing more is looked for."""
ADDED = 0.06
"""A second pass, turned otherwise, covers at least this share more."""
FEWEST = 0.35
"""What covers less than this share is not worth it."""
TURNS = np.radians([0, 90, -90, 180, 45, -45])
"""How what is held may be turned from where its edges lie along those of the top [rad]."""


@dataclass(frozen=True, slots=True, eq=False)
class Pass:
    """What is wiped at one go; joint angles, shapes (n, joints) [rad]."""

    carry: Array
    """To above the middle of the level."""
    lower: Array
    """Down to ``NEAR`` above it."""
    course: Array
    """Where to go from there, in the plane, shape (n, 2) [m]; it ends where it began."""


@dataclass(frozen=True, slots=True, eq=False)
class _Option:
    """A pass but for the way to where it begins."""

    lower: Array
    course: Array
    covered: Mask
    """Which of the level's points, shape (n,)."""


class Wiping:
    """Chooses how to wipe with what is in the gripper."""

    def __init__(self, physics: Physics, collisions: Collisions, rng: np.random.Generator) -> None:
        self._physics = physics
        self._collisions = collisions
        self._arm = collisions.arm
        self._rng = rng
        self._obstacles: Counter[str] = Counter()

    def choose(self, name: str, surface: str, cloud: Cloud) -> tuple[Pass, ...]:
        """One pass, or two turned differently where that covers more.

        Args:
            name: what is held, its underside level.
            surface: what is wiped.
            cloud: of that.

        Raises:
            ActionFailure: nothing covers enough.
        """
        level = SeenLevel(cloud)
        points, _ = self._collisions.shape(name)
        self._collisions.refresh()
        passes: list[Pass] = []
        covered = np.zeros(len(level.spread), bool)
        with self._collisions.carrying(name):
            options = self._options(level, points)
            start = self._physics.joints
            while options and len(passes) < 2 and covered.mean() < ENOUGH:
                best = max(options, key=lambda each: float((each.covered | covered).mean()))
                options.remove(best)
                least = covered.mean() + (ADDED if passes else FEWEST)
                if (best.covered | covered).mean() < least:
                    break
                carry = self._carry(start, best.lower[0])
                if carry is not None:
                    passes.append(Pass(carry, best.lower, best.course))
                    covered, start = covered | best.covered, best.lower[0]
        if not passes:
            raise self._failure(name, surface)
        return tuple(passes)

    def _options(self, level: SeenLevel, points: Array) -> list[_Option]:
        """Passes with what is held, points (n, 3), turned in all ways."""
        held, tool = self._arm.forward(self._physics.joints), Rectangle.about(points[:, :2])
        bottom = np.append(tool.middle, points[:, 2].min())
        shift = np.append(level.middle, level.height + GAP) - bottom
        found: list[_Option] = []
        for turn in TURNS + (level.yaw - tool.yaw):
            pose = turned(held, bottom, turn)
            pose[:3, 3] += shift
            patch = Patch(level, tool.yaw + turn, tool.half)
            for lower, joints in self._lowered(pose, level.highest + HOVER - level.height):
                found.append(_Option(lower, *self._rows(patch, pose, joints)))
                if found[-1].covered.mean() > ENOUGH:
                    return found
        return found

    def _failure(self, name: str, surface: str) -> ActionFailure:
        why = self._obstacles.most_common(1)
        reason = f": {why[0][0]}" if why else ""
        return ActionFailure(
            "wipe",
            f"no way to draw {name} over enough of {surface} was found{reason}",
            pose=kinematics.pose(self._arm.forward(self._physics.joints)),
        )

    def _carry(self, start: Array, end: Array) -> Array | None:
        opening = self._physics.opening

        def blocked(joints: Array) -> bool:
            return self._collisions.find(joints, opening, CLEARANCE) is not None

        return free_path(self._arm, start, end, blocked, self._rng)

    def _lowered(self, pose: Array, rise: float) -> Iterator[tuple[Array, Array]]:
        """Ways down to ``NEAR``, shapes (n, joints), and the joint angles at the pose itself."""
        above, near = pose.copy(), pose.copy()
        above[2, 3] += rise
        near[2, 3] += NEAR
        postures = self._arm.inverse(above, self._physics.joints)[:BRANCHES]
        if len(postures) == 0:
            self._obstacles["the arm cannot get there"] += 1
        for joints in postures:
            lower = self._free(above, near, joints)
            rest = None if lower is None else self._free(near, pose, lower[-1])
            if lower is not None and rest is not None:
                yield lower, rest[-1]

    def _free(self, start: Array, end: Array, joints: Array) -> Array | None:
        """The line between two poses where the arm can follow it and touches nothing."""
        path = self._arm.line(start, end, joints)
        if path is None:
            self._obstacles["the arm cannot get there"] += 1
            return None
        hit = self._collisions.first_along(path[1:], self._physics.opening, GRAZING)
        if hit is not None:
            self._obstacles[f"collision of {hit}"] += 1
        return path if hit is None else None

    def _rows(self, patch: Patch, pose: Array, joints: Array) -> tuple[Array, Mask]:
        """Rows along the longer way there is for what is held.

        Args:
            patch: what is held, over the level.
            pose: of the gripper with its middle over that of the level, shape (4, 4).
            joints: with them it is there.

        Returns:
            The course and what is covered; see ``Pass`` and ``_Option``.
        """
        room, reach = patch.room, patch.reach
        # Where there is no room either way: along what is drawn over, which is less easily tipped.
        along = max((0, 1), key=lambda axis: (max(SHORTEST, room[axis]), reach[axis]))
        ahead, aside = patch.axes[[along, 1 - along]]
        low, high = self._span(patch, pose, joints, np.zeros(2), aside * room[1 - along])
        width = 2 * float(patch.half[1 - along])
        count = min(ROWS, math.ceil((high - low) / width - 1e-9) + 1)
        course, covered = [], np.zeros(len(patch.level.spread), bool)
        for offset in np.linspace(low, high, count) if count > 1 else np.zeros(1):
            row = offset * aside
            there = self._arm.line(pose, _moved(pose, row), joints)
            if there is None:
                continue
            wish = ahead * max(SHORTEST, float(room[along]))
            back, on = self._span(patch, pose, there[-1], row, wish)
            ends = row + back * ahead, row + on * ahead
            course += [row, *ends, row]
            covered |= patch.covers(*ends)
        return np.array([*course, np.zeros(2)]), covered

    def _span(
        self, patch: Patch, pose: Array, joints: Array, place: Array, wish: Array
    ) -> tuple[float, float]:
        """How far it gets from a place, shape (2,), back and on along a wish, shape (2,) [m]."""
        length = float(np.hypot(*wish))
        ends: list[float] = []
        for towards in (-wish, wish):
            at, there, gone = place, joints, 0.0
            while gone < length - 1e-9:
                step = min(STEP, length - gone)
                following = at + towards * (step / length)
                if not patch.fits(following):
                    break
                path = self._free(_moved(pose, at), _moved(pose, following), there)
                if path is None:
                    gone = max(0.0, gone - SPARE)
                    break
                at, there, gone = following, path[-1], gone + step
            ends.append(gone)
        return -ends[0], ends[1]


def _moved(pose: Array, place: Array) -> Array:
    """The pose, shape (4, 4), moved in the plane by a displacement, shape (2,) [m]."""
    result = pose.copy()
    result[:2, 3] += place
    return result
