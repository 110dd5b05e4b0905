"""Relations between objects, read from their poses and contacts.

Everything is in the table frame: x forward, y to the robot's left, z up. ``in`` and ``on`` speak of
what rests: an object in the gripper is in and on nothing.
"""

import copy
import math
from collections.abc import Callable
from itertools import product

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.condition import Relation
from app.worlds.simulators.mujoco.collision import robot_bodies
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.placement import REACH
from app.worlds.simulators.mujoco.scene_builder import ObjectBody
from app.worlds.simulators.mujoco.surface import surface_points

Array = NDArray[np.float64]

RELATIONS = {
    "in": 2, "on": 2, "left_of": 2, "right_of": 2, "in_front_of": 2, "behind": 2, "near": 2,
    "upright": 1, "held": 1, "open": 1, "closed": 1, "clear": 1, "handed_over": 1,
    "poured": 2, "wiped": 1,
}  # fmt: skip
"""What can be decided, with the number of arguments."""
TOUCH = 0.001
"""Surfaces this close touch [m]."""
NEAR = 0.10
"""Objects whose surfaces are at most this far apart are near one another [m]."""
BESIDE = 0.02
"""So much farther left its centre must be for one object to be left of another [m]; likewise for
right, in front and behind."""
UPRIGHT = math.cos(math.radians(20))
"""Its up axis, as it stood when placed, leans at most so far."""
HEAP = 0.03
"""What lies on other contents may begin this far above the rim and still be in the container [m]."""
SUNK = 0.002
"""What lies on the container itself must reach so far below its rim to be in it [m]."""
AJAR, SHUT = 0.6, 0.08
"""What has a lid, door or drawer is open from this share of its travel on, and closed up to that."""
ACROSS = REACH[1] + 0.005
"""What stands so far ahead of the robot is within reach of the person across the table [m]; no scene
begins with an object there."""
MOST_BEADS = 0.8
"""This share of the beads must have arrived."""
MOST_OF_TOP = 0.6
"""This share of a level top must have been rubbed; a rim keeps the gripper from the rest."""
CARRIES = 0.5
"""The upward part of the normal from which on a contact carries what is above it."""


class Relations:
    """What is true of the objects as they stand now."""

    def __init__(self, physics: Physics) -> None:
        self._physics = physics
        self._bodies = physics.bodies
        self._model = copy.copy(physics.model)
        self._model.geom_margin[:] = TOUCH
        self._model.geom_gap[:] = 0.0
        self._model.body_margin[:] = TOUCH
        self._data = mujoco.MjData(self._model)
        self._fingers = {self._model.body(name).id for name in physics.arm.fingers}
        robot = robot_bodies(self._model, physics.arm)
        self._owner = np.arange(self._model.nbody)
        for body in self._bodies.values():
            self._owner[list(body.parts)] = body.body_id
        objects = {part for body in self._bodies.values() for part in body.parts}
        objects.update(*physics.beads.values())
        self._ground = {
            body for body in range(self._model.nbody) if body not in objects and not robot[body]
        }

    def holds(self, relation: Relation) -> bool:
        """Whether the relation is true now.

        - ``in(a, b)``: b is a container standing upright, a's centre of mass is over its opening,
          and a rests on b, itself or on other contents, and not on the table.
        - ``on(a, b)``: b carries a's weight from below, or b is flat, a plate or a tray, and a is
          in it.
        - ``left_of(a, b)``: a's centre is at least ``BESIDE`` farther to the robot's left (+y).
        - ``in_front_of(a, b)``: a's centre is at least ``BESIDE`` nearer to the robot (-x), which looks
          over the table from its base; ``behind(a, b)``: so much farther away.
        - ``near(a, b)``: their surfaces are at most ``NEAR`` apart.
        - ``upright(a)``: a stands as it was placed, leaning at most 20 degrees.
        - ``held(a)``: both fingers touch a.
        - ``open(a)``: a is a container, and its lid, door or drawer, if it has one, is open.
        - ``closed(a)``: a has a lid, door or drawer, and it is shut; it may be neither.
        - ``clear(a)``: nothing is on a.
        - ``handed_over(a)``: a stands on the table, its middle at least ``ACROSS`` ahead of the robot,
          before the person on the other side, and nothing holds it.
        - ``poured(a, b)``: of the beads that were in a, at least ``MOST_BEADS`` lie in b.
        - ``wiped(a)``: something in the gripper was drawn over at least ``MOST_OF_TOP`` of a's level
          top, touching a; see ``rubbing``.
        """
        items = [self._bodies.get(name) for name in relation.arguments]
        if None in items or len(items) != RELATIONS.get(relation.name):
            return False
        self._observe()
        return _DECIDE[relation.name](self, *items)

    def facts(self) -> frozenset[Relation]:
        """Every ``in``, ``on`` and ``held`` that is true now, and what can be shut: open or closed."""
        self._observe()
        bodies = self._bodies.values()
        true = [
            Relation(name, (first.name, second.name))
            for first, second in product(bodies, bodies)
            for name in ("in", "on")
            if first is not second and _DECIDE[name](self, first, second)
        ]
        true += [Relation("held", (item.name,)) for item in bodies if self._held(item)]
        return frozenset(true) | self.shutting()

    def shutting(self) -> frozenset[Relation]:
        """Which of what has a lid, a door or a drawer is open, and which closed."""
        self._observe()
        return frozenset(
            Relation(name, (item.name,))
            for item in self._bodies.values()
            for name in ("open", "closed")
            if item.joint is not None and _DECIDE[name](self, item)
        )

    def place(self, name: str) -> Array:
        """What counts as an object's middle, shape (2,): of its bounding box and its mass [m]."""
        data = self._physics.stand()
        mujoco.mj_comPos(self._physics.model, data)
        body = self._bodies[name].body_id
        points = surface_points(self._physics.model, data, body)
        box = (points.min(axis=0) + points.max(axis=0)) / 2
        return ((box + data.xipos[body]) / 2)[:2]

    def extent(self, name: str) -> Array:
        """Half the width of an object along x and along y as it stands now, shape (2,) [m]."""
        data = self._physics.stand()
        points = surface_points(self._physics.model, data, self._bodies[name].body_id)
        return ((points.max(axis=0) - points.min(axis=0)) / 2)[:2]

    def on_table(self, name: str) -> bool:
        """Whether an object touches the table and nothing holds it."""
        self._observe()
        item = self._bodies[name]
        return self._on_ground(item) and not self._held(item)

    def every_fact(self) -> frozenset[Relation]:
        """Everything that is true now, of all relations."""
        self._observe()
        bodies = self._bodies.values()
        true: list[Relation] = []
        for name, count in RELATIONS.items():
            for items in product(bodies, repeat=count):
                if len(set(map(id, items))) == count and _DECIDE[name](self, *items):
                    true.append(Relation(name, tuple(item.name for item in items)))
        return frozenset(true)

    def _observe(self) -> None:
        data = self._data
        data.qpos[:] = self._physics.data.qpos
        mujoco.mj_kinematics(self._model, data)
        mujoco.mj_collision(self._model, data)
        pairs = self._owner[self._model.geom_bodyid[data.contact.geom[: data.ncon]]].reshape(-1, 2)
        upward = data.contact.frame[: data.ncon].reshape(-1, 9)[:, 2]
        self._touching: set[tuple[int, int]] = set()
        self._carrying: set[tuple[int, int]] = set()
        for (first, second), up in zip(pairs.tolist(), upward.tolist(), strict=True):
            self._touching |= {(first, second), (second, first)}
            if abs(up) > CARRIES:  # the normal points from the first to the second
                self._carrying.add((first, second) if up > 0 else (second, first))

    def _on_ground(self, item: ObjectBody) -> bool:
        return any((item.body_id, ground) in self._touching for ground in self._ground)

    def _held(self, item: ObjectBody) -> bool:
        return all((item.body_id, finger) in self._touching for finger in self._fingers)

    def _in(self, item: ObjectBody, container: ObjectBody) -> bool:
        if item is container or self._on_ground(item) or not self._upright(container):
            return False
        if not self._over_opening(item, container):
            return False
        reached, unvisited = {container.body_id}, [container.body_id]
        contents = {
            other.body_id
            for other in self._bodies.values()
            if self._over_opening(other, container) and not self._held(other)
        }
        while unvisited:
            body = unvisited.pop()
            touched = {other for other in contents if (body, other) in self._touching} - reached
            reached |= touched
            unvisited += touched
        return item.body_id in reached

    def _over_opening(self, item: ObjectBody, container: ObjectBody) -> bool:
        opening = container.opening
        if opening is None or item is container:
            return False
        centre = self._in_cavity(item.body_id, container)
        data = self._data
        if not _within(centre, opening) or centre[2] <= opening.floor:
            return False
        above = self._lowest(item) - float(data.xpos[container.cavity][2]) - opening.rim
        # What lies across the rim, as a pen over a cup, touches the container and hangs over it.
        touches = (item.body_id, container.body_id) in self._touching
        return opening.flat or above < (-SUNK if touches else HEAP)

    def _on(self, item: ObjectBody, support: ObjectBody) -> bool:
        if item is support or self._held(item):
            return False
        if (support.body_id, item.body_id) in self._carrying:
            inside = support.opening is not None and self._over_opening(item, support)
            if not inside:
                return True
        return support.opening is not None and support.opening.flat and self._in(item, support)

    def _right_of(self, item: ObjectBody, other: ObjectBody) -> bool:
        return self._left_of(other, item)

    def _left_of(self, item: ObjectBody, other: ObjectBody) -> bool:
        y = self._data.xipos[:, 1]
        return bool(y[item.body_id] - y[other.body_id] > BESIDE)

    def _upright(self, item: ObjectBody) -> bool:
        return bool(self._data.xmat[item.body_id][8] > UPRIGHT)

    def _in_front_of(self, item: ObjectBody, other: ObjectBody) -> bool:
        return self._behind(other, item)

    def _behind(self, item: ObjectBody, other: ObjectBody) -> bool:
        x = self._data.xipos[:, 0]
        return bool(x[item.body_id] - x[other.body_id] > BESIDE)

    def _open(self, item: ObjectBody) -> bool:
        if item.joint is not None:
            return self._travel(item) > AJAR
        return item.opening is not None

    def _closed(self, item: ObjectBody) -> bool:
        return item.joint is not None and self._travel(item) < SHUT

    def _travel(self, item: ObjectBody) -> float:
        """How far its lid, door or drawer has moved from shut, 0, to wholly open, 1."""
        assert item.joint is not None
        low, high = self._model.jnt_range[item.joint]
        return float((self._data.qpos[self._model.jnt_qposadr[item.joint]] - low) / (high - low))

    def _clear(self, item: ObjectBody) -> bool:
        return not any(self._on(other, item) for other in self._bodies.values())

    def _handed_over(self, item: ObjectBody) -> bool:
        if not self._on_ground(item) or self._held(item):
            return False
        return bool(self.place(item.name)[0] > ACROSS)

    def _poured(self, source: ObjectBody, target: ObjectBody) -> bool:
        beads = self._physics.beads.get(source.name, ())
        opening = target.opening
        if not beads or opening is None or source is target:
            return False
        places = [self._in_cavity(bead, target) for bead in beads]
        arrived = [_within(p, opening) and 0 < p[2] < opening.rim + HEAP for p in places]
        return sum(arrived) >= MOST_BEADS * len(beads)

    def _wiped(self, item: ObjectBody) -> bool:
        rubbing = self._physics.rubbing
        return rubbing is not None and rubbing.share(self._physics.data, item.name) >= MOST_OF_TOP

    def _in_cavity(self, body: int, container: ObjectBody) -> Array:
        """A body's centre of mass in the frame of the container's opening, shape (3,) [m]."""
        rotation = self._data.xmat[container.cavity].reshape(3, 3)
        return rotation.T @ (self._data.xipos[body] - self._data.xpos[container.cavity])

    def _near(self, item: ObjectBody, other: ObjectBody) -> bool:
        if item is other or self._far_apart(item, other):
            return False
        ends = np.zeros(6)
        return any(
            mujoco.mj_geomDistance(self._model, self._data, first, second, NEAR, ends) < NEAR
            for first, second in product(self._solid(item), self._solid(other))
        )

    def _far_apart(self, item: ObjectBody, other: ObjectBody) -> bool:
        """Whether even balls about both, as large as they can be, are not near one another."""
        positions = self._data.xpos
        apart = np.linalg.norm(positions[item.body_id] - positions[other.body_id])
        return bool(apart > NEAR + _extent(item) + _extent(other))

    def _solid(self, item: ObjectBody) -> list[int]:
        """The geoms of an object that touch others."""
        own = np.isin(self._model.geom_bodyid, item.parts)
        return np.flatnonzero(own & (self._model.geom_contype != 0)).tolist()

    def _lowest(self, item: ObjectBody) -> float:
        """Height of the lowest corner of its geoms' bounding boxes [m]."""
        return min(self._lowest_corner(geom) for geom in self._solid(item))

    def _lowest_corner(self, geom: int) -> float:
        middle, half = self._model.geom_aabb[geom][:3], self._model.geom_aabb[geom][3:]
        up = self._data.geom_xmat[geom].reshape(3, 3)[2]
        height = self._data.geom_xpos[geom][2] + up @ middle - np.abs(up) @ half
        return float(height)


def _within(centre: Array, opening: Opening) -> bool:
    """Whether a point of the opening's frame, shape (3,), is inside its outline, seen from above."""
    half = np.array(opening.half_extents)
    if opening.shape == "round":
        return float(np.hypot(*(centre[:2] / half))) < 1.0
    return bool(np.all(np.abs(centre[:2]) < half))


def _extent(item: ObjectBody) -> float:
    """From the object's origin to its farthest corner, at most [m]."""
    return math.hypot(item.footprint_radius, item.height)


# Kept outside the instances: bound methods in one would make a cycle, and the memory of a whole
# scene would wait for the collector.
_DECIDE: dict[str, Callable[..., bool]] = {
    name: getattr(Relations, f"_{name}") for name in RELATIONS
}
