"""Kinematics of the Panda arm: where its tool is, and the joint angles that bring it there.

A pose is a homogeneous transform, shape (4, 4), of the tool frame ``tcp`` in the robot's base frame:
origin between the finger tips, x across the fingers, y along the closing direction, z the approach
direction [m].
"""

import math

import frankik
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from app.domain.pose import Pose

Array = NDArray[np.float64]

HAND_LENGTH = 0.1034
"""From the flange to the point between the finger tips [m]."""
LOWER = np.array([-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973])
UPPER = np.array([2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973])
"""The joints' limits [rad], from the maker's data sheet."""
CLEARANCE = 0.03
"""How far from its limit every joint is kept [rad]."""
HOME = np.array([0.0, -0.35, 0.0, -2.3, 0.0, 1.95, 0.785])
"""The arm drawn back, its cameras' view of the table clear [rad]."""
SWEEP = np.linspace(-2.8, 2.8, 25)
"""Angles of the last joint that are tried, since seven joints leave one free [rad]."""
TOLERANCE = 1e-4
"""How far a solution's pose may be from the one asked for, in any entry of the transform."""
LINE_STEP = 0.01
"""Distance between neighbouring poses of a straight line [m]."""
SHOULDER = np.array([0.0, 0.0, 0.333])
"""Around it the arm reaches about as far in every direction [m]."""
MISSES = (0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5)
"""How much nearer the shoulder a pose is tried that is out of reach [m]."""
NEAR_LIMIT = 0.15
"""A joint so near its limit is said to be there [rad]."""
LARGEST_TURN = 0.25
"""The most a joint may turn from one pose of a line to the next [rad]."""


def _tcp_from_flange() -> Array:
    # The hand is screwed on turned by -45 degrees. frankik's own constant rounds sin 45 to 0.707,
    # which is no rotation any more.
    half = math.sqrt(0.5)
    transform = np.eye(4)
    transform[:2, :2] = [[half, half], [-half, half]]
    transform[2, 3] = HAND_LENGTH
    return transform


_FLANGE_FROM_TCP = np.linalg.inv(_tcp_from_flange())


def forward(joints: Array) -> Array:
    """The tool's pose in the base frame, shape (4, 4), with the joints at these angles [rad]."""
    return np.asarray(frankik.fk(joints))


def inverse(tool: Array, near: Array, sweep: Array = SWEEP) -> Array:
    """The joint angles that bring the tool to a pose, the least motion from ``near`` first.

    Args:
        tool: pose of the tool in the base frame, shape (4, 4).
        near: joint angles to stay close to, shape (7,) [rad].
        sweep: angles of the last joint to try, shape (k,) [rad].

    Returns:
        Solutions inside the joint limits, shape (n, 7) [rad]; n may be 0.
    """
    flange = tool @ _FLANGE_FROM_TCP
    found = np.concatenate([frankik.ik_full(flange, near, angle, False) for angle in sweep])
    # A comparison with NaN, frankik's "no solution", is false.
    inside = np.all((found > LOWER + CLEARANCE) & (found < UPPER - CLEARANCE), axis=1)
    # Next to a singularity the closed form is off by millimetres; such solutions are no use.
    found = np.array([q for q in found[inside] if _reaches(q, tool)]).reshape(-1, 7)
    apart = np.abs(found - near)  # (n, 7)
    cost = apart.max(axis=1, initial=0.0) + 0.3 * np.sqrt((apart**2).sum(axis=1))
    return found[np.argsort(cost, kind="stable")]


def missed(tool: Array, near: Array) -> str:
    """How far a pose without a solution is out of reach, and what stops the arm there.

    Args:
        tool: pose of the tool in the base frame, shape (4, 4).
        near: joint angles to stay close to, shape (7,) [rad].
    """
    inwards = SHOULDER - tool[:3, 3]
    inwards /= np.linalg.norm(inwards)
    for distance in MISSES:
        pulled = tool.copy()
        pulled[:3, 3] += inwards * distance
        found = inverse(pulled, near)
        if len(found):
            spare = np.minimum(found - LOWER, UPPER - found).min(axis=0)  # (7,)
            joint = int(np.argmin(spare)) + 1
            stop = f", where joint {joint} is at its limit" if spare.min() < NEAR_LIMIT else ""
            return f"it is missed by {distance:.2f} m{stop}"
    return "no joint angles turn the gripper that way around there"


def pose(tool: Array) -> Pose:
    """A homogeneous transform, shape (4, 4), as position and quaternion."""
    x, y, z = tool[:3, 3].tolist()
    a, b, c, d = Rotation.from_matrix(tool[:3, :3]).as_quat(scalar_first=True).tolist()
    return Pose(position=(x, y, z), quaternion=(a, b, c, d))


def _reaches(joints: Array, tool: Array) -> bool:
    return bool(np.abs(frankik.fk(joints) - tool).max() < TOLERANCE)


def line(start: Array, end: Array, joints: Array) -> Array | None:
    """Joint angles along the straight line from ``start`` to ``end``, the tool not turning.

    Args:
        start: pose where the line begins, shape (4, 4); ``end`` has the same orientation.
        end: pose where it ends, shape (4, 4).
        joints: angles at the start, shape (7,) [rad].

    Returns:
        Angles of poses ``LINE_STEP`` apart, shape (n, 7) [rad], or None if the arm cannot follow.
    """
    way = end[:3, 3] - start[:3, 3]
    count = max(1, math.ceil(float(np.linalg.norm(way)) / LINE_STEP))
    path = [joints]
    for index in range(1, count + 1):
        pose = end.copy()
        pose[:3, 3] = start[:3, 3] + way * (index / count)
        following = _next(pose, path[-1])
        if following is None:
            return None
        path.append(following)
    return np.array(path)


def _next(pose: Array, joints: Array) -> Array | None:
    """The solution next to ``joints``, the last joint allowed to drift a little where it must."""
    for drift in (0.0, 0.03, -0.03, 0.08, -0.08):
        found = inverse(pose, joints, np.array([joints[6] + drift]))
        if len(found) and float(np.abs(found[0] - joints).max()) < LARGEST_TURN:
            return found[0]
    return None
