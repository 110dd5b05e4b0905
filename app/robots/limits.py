"""Limits: whether a trajectory keeps to what an arm may do."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.domain.robot import JointTrajectory, RobotLimits, TrajectoryRefused

Array = NDArray[np.float64]
Forward = Callable[[Array], Array]
"""From joint angles, shape (n,) [rad], to the tool's pose in the base frame, shape (4, 4) [m]."""

SLACK = 0.002
"""What a measured angle [rad] or opening [m] may be beyond its range by noise."""
STRIDE = 0.05
"""The most a joint turns between two checks of the workspace [rad]."""
MAX_POINTS = 100_000


def check(trajectory: JointTrajectory, limits: RobotLimits, forward: Forward) -> None:
    """Let a trajectory pass that keeps to all limits, its ways between the points too.

    Raises:
        TrajectoryRefused: it does not; the first limit it breaks is named, and where.
    """
    times, joints, openings = _arrays(trajectory, len(limits.speed))
    if trajectory.grip_force > limits.grip_force:
        asked = f"{trajectory.grip_force:.1f} N; the fingers close with at most"
        raise TrajectoryRefused("grip_force", f"is {asked} {limits.grip_force:.1f} N")
    _check_joints(times, joints, limits)
    wrong = np.flatnonzero((openings < -SLACK) | (openings > limits.opening + SLACK))
    if len(wrong):
        at = f"{openings[wrong[0]]:.3f} m at {times[wrong[0]]:.2f} s"
        raise TrajectoryRefused("opening", f"is {at}; it is from 0 to {limits.opening:.3f} m")
    _check_workspace(times, joints, limits, forward)


def _arrays(trajectory: JointTrajectory, width: int) -> tuple[Array, Array, Array]:
    """Times (n,), joints (n, width), openings (n,)."""
    count = len(trajectory.times)
    if not 2 <= count <= MAX_POINTS:
        raise TrajectoryRefused("points", f"are {count}; from 2 to {MAX_POINTS:,} are taken")
    if {len(row) for row in trajectory.positions} != {width}:
        raise TrajectoryRefused("positions", f"do not have {width} joints each")
    if not len(trajectory.positions) == len(trajectory.openings) == count:
        raise TrajectoryRefused("points", "do not have a time, a position and an opening each")
    times = np.array(trajectory.times)
    joints, openings = np.array(trajectory.positions), np.array(trajectory.openings)
    numbers = np.column_stack([times, joints, openings])
    if not np.isfinite(numbers).all() or not np.isfinite(trajectory.grip_force):
        raise TrajectoryRefused("points", "are not all made of numbers")
    if (np.diff(times) <= 0).any():
        at = times[1:][np.diff(times) <= 0][0]
        raise TrajectoryRefused("times", f"do not increase at {at:.3f} s")
    return times, joints, openings


def _check_joints(times: Array, joints: Array, limits: RobotLimits) -> None:
    beyond = np.maximum(np.array(limits.lowest) - joints, joints - np.array(limits.highest))
    if beyond.max() > SLACK:
        point, joint = np.unravel_index(beyond.argmax(), beyond.shape)
        where = f"joint {joint + 1} at {joints[point, joint]:.3f} rad, {times[point]:.2f} s"
        range_ = f"{limits.lowest[joint]} to {limits.highest[joint]} rad"
        raise TrajectoryRefused("joint_range", f"is broken by {where}; it turns from {range_}")
    speeds = np.abs(np.diff(joints, axis=0)) / np.diff(times)[:, None]
    over = speeds / np.array(limits.speed)
    if over.max() > 1.0:
        point, joint = np.unravel_index(over.argmax(), over.shape)
        where = f"joint {joint + 1} with {speeds[point, joint]:.2f} rad/s, {times[point]:.2f} s"
        most = f"{limits.speed[joint]:.2f} rad/s"
        raise TrajectoryRefused("speed", f"is broken by {where}; at most {most} is allowed")


def _check_workspace(times: Array, joints: Array, limits: RobotLimits, forward: Forward) -> None:
    low, high = np.array(limits.workspace)
    for index, (start, end) in enumerate(pairwise(joints)):
        steps = int(np.ceil(np.abs(end - start).max() / STRIDE)) or 1
        for share in np.linspace(0.0, 1.0, steps + 1):
            tip = forward(start + share * (end - start))[:3, 3]
            if (tip < low).any() or (tip > high).any():
                x, y, z = (round(float(value), 3) for value in tip)
                where = f"the finger tips at ({x}, {y}, {z}) m, {times[index]:.2f} s"
                box = f"{low.tolist()} to {high.tolist()} m"
                raise TrajectoryRefused("workspace", f"is left by {where}; it is {box}")
