"""Motion: free paths through joint space, and the time course along them."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.arm import CLEARANCE, Arm

Array = NDArray[np.float64]
Blocked = Callable[[Array], bool]
"""Whether the arm would hit something at these joint angles, shape (joints,) [rad]."""

RESOLUTION = 0.03
"""The most a joint turns between two checks along an edge [rad]."""
STRIDE = 0.25
"""The most a joint turns from one node of a tree to the next [rad]."""
NODE_BUDGET = 400
"""How often the trees are extended before the search gives up."""
SHORTCUTS = 40
"""How many random shortcuts are tried on a path that was found."""
SHORTEST = 0.15
"""No motion takes less than this [s]."""
# Peak speed and acceleration of the minimum-jerk course of unit length and duration.
_PEAK_SPEED = 1.875
_PEAK_ACCELERATION = 10 / math.sqrt(3)


def free_path(
    arm: Arm, start: Array, goal: Array, blocked: Blocked, rng: np.random.Generator
) -> Array | None:
    """A path clear of collisions: the straight line if it is free, else one a search finds.

    Args:
        arm: whose joints they are.
        start: joint angles, shape (joints,) [rad]; not checked itself.
        goal: joint angles, shape (joints,) [rad].
        blocked: where the arm cannot be.
        rng: where the search's samples come from.

    Returns:
        Corner points from start to goal, shape (n, joints) [rad], or None if the budget ran out.
    """
    if blocked(goal):
        return None
    if _edge_free(start, goal, blocked):
        return np.array([start, goal])
    path = _connect(arm, start, goal, blocked, rng)
    return None if path is None else np.array(_shortened(path, blocked, rng))


def timed(arm: Arm, path: Array, speed: float, timestep: float) -> tuple[Array, Array]:
    """The minimum-jerk course along a path: at rest at both ends.

    s(u) = 10 u³ - 15 u⁴ + 6 u⁵ over the arc length s, measured by the slowest joint.

    Args:
        arm: whose joints they are.
        path: joint angles along the way, shape (n, joints) [rad], n >= 2.
        speed: fraction of the joints' limits that is made use of.
        timestep: time between two set points [s].

    Returns:
        Set points and their velocities, both shape (k, joints) [rad], [rad/s].
    """
    lengths = (np.abs(np.diff(path, axis=0)) / arm.speed).max(axis=1)
    arc = np.concatenate([[0.0], np.cumsum(lengths)]) / speed  # seconds at full speed, (n,)
    reach = np.abs(path[-1] - path[0]) / (arm.acceleration * speed**2)
    seconds = max(_PEAK_SPEED * arc[-1], math.sqrt(_PEAK_ACCELERATION * reach.max()), SHORTEST)
    count = math.ceil(seconds / timestep)
    u = np.arange(1, count + 1) / count
    along = (10 * u**3 - 15 * u**4 + 6 * u**5) * arc[-1]
    points = np.stack(
        [np.interp(along, arc, path[:, joint]) for joint in range(arm.joints)], axis=1
    )
    return points, np.gradient(points, timestep, axis=0)


def _edge_free(start: Array, end: Array, blocked: Blocked) -> bool:
    """Whether the straight line is free; its ends and middle are tried before the rest."""
    count = math.ceil(float(np.abs(end - start).max()) / RESOLUTION)
    return not any(blocked(start + (end - start) * (k / count)) for k in _coarse_to_fine(count))


def _coarse_to_fine(count: int) -> list[int]:
    """1 … count in an order that spreads over the whole range early: a hit is found sooner."""
    order = [count] if count else []
    stride = 1 << max(0, count.bit_length() - 1)
    while stride:
        order += range(stride, count, 2 * stride)
        stride //= 2
    return order


class _Tree:
    """Joint angles that can be reached from a root, each with the node it came from."""

    def __init__(self, root: Array) -> None:
        self.nodes = [root]
        self.parents = [-1]

    def extend(self, towards: Array, blocked: Blocked, *, all_the_way: bool) -> tuple[int, bool]:
        """Grow towards a point; the last node and whether it is that point."""
        at = int(np.argmin(np.linalg.norm(np.array(self.nodes) - towards, axis=1)))
        while True:
            way = towards - self.nodes[at]
            length = float(np.abs(way).max())
            arrives = length < STRIDE
            node = towards if arrives else self.nodes[at] + way * (STRIDE / length)
            if not _edge_free(self.nodes[at], node, blocked):
                return at, False
            self.nodes.append(node)
            self.parents.append(at)
            at = len(self.nodes) - 1
            if arrives or not all_the_way:
                return at, arrives

    def way_back(self, at: int) -> list[Array]:
        """From a node to the root."""
        path: list[Array] = []
        while at != -1:
            path.append(self.nodes[at])
            at = self.parents[at]
        return path


def _connect(
    arm: Arm, start: Array, goal: Array, blocked: Blocked, rng: np.random.Generator
) -> list[Array] | None:
    """RRT-connect (Kuffner and LaValle, 2000), sampling near the straight line for the most part."""
    growing, other = _Tree(start), _Tree(goal)
    forwards = True
    for _ in range(NODE_BUDGET):
        anywhere = rng.uniform(arm.lowest, arm.highest)
        nearby = (start + goal) / 2 + rng.normal(0.0, 0.5, arm.joints)
        sample = anywhere if rng.random() < 0.3 else nearby
        sample = np.clip(sample, arm.lowest + CLEARANCE, arm.highest - CLEARANCE)
        before = len(growing.nodes)
        at, _arrived = growing.extend(sample, blocked, all_the_way=False)
        if len(growing.nodes) > before:
            meeting, met = other.extend(growing.nodes[at], blocked, all_the_way=True)
            if met:
                path = growing.way_back(at)[::-1] + other.way_back(meeting)[1:]
                return path if forwards else path[::-1]
        growing, other, forwards = other, growing, not forwards
    return None


def _shortened(path: list[Array], blocked: Blocked, rng: np.random.Generator) -> list[Array]:
    """The path with detours cut off where the straight line is free."""
    for _ in range(SHORTCUTS):
        if len(path) < 3:
            break
        first = int(rng.integers(0, len(path) - 2))
        last = int(rng.integers(first + 2, len(path)))
        if _edge_free(path[first], path[last], blocked):
            path = path[: first + 1] + path[last:]
    return path
