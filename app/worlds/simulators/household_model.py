"""A home as a doll's house in MuJoCo: what the viewer draws and what the frames' qpos moves.

Nothing is simulated: things slide, doors turn and lamps rise as ``HouseholdFilm`` puts them.
"""

import hashlib

import mujoco
import numpy as np

from app.worlds.simulators.household_graph import HouseholdGraph, Node
from app.worlds.simulators.household_layout import HomeLayout, Solid

WIDTH = 1.35
"""How wide the drawn home is, whatever its true size [m]."""
MIDDLE = (0.4, 0.0)
"""Where its middle is, before the viewer's camera [m]."""
WALL, THICK = 0.35, 0.05
"""Height and thickness of the walls, which are cut low to look over them [m]."""
BODY, HEAD = 0.2, 0.14
"""Radii of the agent's body and head [m]."""
TALL = 1.7
AGENT_COLOUR = (0.16, 0.42, 0.78, 1.0)
DOOR_COLOUR = (0.55, 0.4, 0.26, 1.0)
LAMP_COLOUR = (1.0, 0.8, 0.1, 1.0)
FLOORS = ((0.76, 0.66, 0.5, 1), (0.5, 0.64, 0.7, 1), (0.72, 0.54, 0.56, 1), (0.54, 0.66, 0.5, 1))
FOVY = 40.0
"""Vertical angle of the watcher's camera [degrees]."""
STEEP = np.radians(66)
"""How far the camera's axis is turned down from level [rad]."""
SHAPE, MARGIN = 4 / 3, 1.16
"""Width of the picture over its height, and the home's room in it over its size."""
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class HomeModel:
    """The bodies of a home, and the numbers of their joints among the generalized coordinates."""

    def __init__(self, graph: HouseholdGraph) -> None:
        """Lay the home out; ``compile`` makes MuJoCo's model of it."""
        self.layout = HomeLayout(graph)
        corners = [_corners(self.layout.solids[room.id]) for room in self.layout.rooms]
        low = np.min([corner[0] for corner in corners], axis=0)
        high = np.max([corner[1] for corner in corners], axis=0)
        self.scale = WIDTH / float(max(high - low))
        self._middle = (low + high) / 2
        self._extent = (high - low) * self.scale
        self.movable = [n for n in self.layout.things if "GRABBABLE" in n.properties]
        fixed = [n for n in self.layout.things if n not in self.movable]
        self.openable = [n for n in fixed if {"OPEN", "CLOSED"} & n.states]
        """What has a door that turns; a book or a box has none."""
        self.switchable = [n for n in self.layout.things if {"ON", "OFF"} & n.states]
        self.size = 4 + 3 * len(self.movable) + len(self.openable) + len(self.switchable)
        """How many generalized coordinates there are (nq)."""
        self.address: dict[int, int] = {}
        """Of the first coordinate of a thing that can be moved, by id; the agent's come first."""
        self.door_address: dict[int, int] = {}
        self.lamp_address: dict[int, int] = {}
        self.units = np.full(self.size, self.scale)
        """What a coordinate in the home's own metres and radians is multiplied by to be qpos."""
        self._count()

    def _count(self) -> None:
        self.units[3] = 1.0
        at = 4
        for node in self.movable:
            self.address[node.id] = at
            at += 3
            if node in self.switchable:
                self.lamp_address[node.id] = at
                at += 1
        for node in self.openable:
            self.door_address[node.id] = at
            self.units[at] = 1.0
            at += 1
        for node in self.switchable:
            if node.id not in self.lamp_address:
                self.lamp_address[node.id] = at
                at += 1

    def compile(self) -> mujoco.MjModel:
        """The model, whose qpos is of length ``size``; at zero everything stands as at first."""
        spec = mujoco.MjSpec()
        spec.modelname = "household"
        spec.option.gravity = (0, 0, 0)
        for index, room in enumerate(self.layout.rooms):
            self._add_room(spec, self.layout.solids[room.id], FLOORS[index % len(FLOORS)])
        for node in self.layout.things:
            if node.id not in self.address:
                _box(spec.worldbody, self._scaled(node), _colour(node), self._place(node))
        self._add_agent(spec)
        self._add_movables(spec)
        for node in self.openable:
            self._add_door(spec, node)
        for node in self.switchable:
            if node.id not in self.address:
                self._add_lamp(spec.worldbody, node, self._place(node))
        self._add_watcher(spec)
        return spec.compile()

    def _add_watcher(self, spec: mujoco.MjSpec) -> None:
        """A camera steeply above the middle, the home's longer side across its picture."""
        sideways = self._extent[1] > self._extent[0]
        across, deep = np.sort(self._extent)[::-1] * MARGIN
        half = np.tan(np.radians(FOVY) / 2)
        # The near edge is the widest in the picture, so the distance is counted from there.
        near = deep / 2 * np.cos(STEEP)
        away = near + max(across / (2 * half * SHAPE), deep * np.sin(STEEP) / (2 * half))
        back = np.array((1.0, 0.0, 0.0) if sideways else (0.0, -1.0, 0.0))
        right = np.cross((0.0, 0.0, 1.0), back)
        up = np.array((0.0, 0.0, np.cos(STEEP))) - back * np.sin(STEEP)
        place = np.array((*MIDDLE, np.sin(STEEP) * away)) + back * np.cos(STEEP) * away
        turn = np.empty(4)
        mujoco.mju_mat2Quat(turn, np.column_stack((right, up, np.cross(right, up))).ravel())
        spec.worldbody.add_camera(name="watcher", pos=place, quat=turn, fovy=FOVY)

    def _add_movables(self, spec: mujoco.MjSpec) -> None:
        for node in self.movable:
            body = spec.worldbody.add_body(name=f"{node.name} {node.id}", pos=self._place(node))
            for axis in AXES:
                body.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE, axis=axis)
            _box(body, self._scaled(node), _colour(node), (0, 0, 0))
            if node.id in self.lamp_address:
                self._add_lamp(body, node, (0, 0, 0))

    def _place(self, node: Node) -> tuple[float, float, float]:
        return self.in_view(self.layout.solids[node.id].centre)

    def in_view(self, point: tuple[float, float, float]) -> tuple[float, float, float]:
        """A point of the home where the viewer has it [m]."""
        x = (point[0] - self._middle[0]) * self.scale + MIDDLE[0]
        y = (point[1] - self._middle[1]) * self.scale + MIDDLE[1]
        return float(x), float(y), point[2] * self.scale

    def _scaled(self, node: Node) -> tuple[float, float, float]:
        width, depth, height = self.layout.solids[node.id].size
        return width * self.scale, depth * self.scale, height * self.scale

    def _add_room(self, spec: mujoco.MjSpec, room: Solid, colour: tuple[float, ...]) -> None:
        (width, depth, _), scale = room.size, self.scale
        x, y, _ = room.centre
        floor = self.in_view((x, y, -0.05))
        _box(spec.worldbody, (width * scale, depth * scale, 0.1 * scale), colour, floor)
        for side in (-1, 1):
            long = (width * scale, THICK * scale, WALL * scale)
            place = self.in_view((x, y + side * depth / 2, WALL / 2))
            _box(spec.worldbody, long, (0.93, 0.92, 0.9, 1), place)
            deep = (THICK * scale, depth * scale, WALL * scale)
            place = self.in_view((x + side * width / 2, y, WALL / 2))
            _box(spec.worldbody, deep, (0.93, 0.92, 0.9, 1), place)

    def _add_agent(self, spec: mujoco.MjSpec) -> None:
        """At the home's own origin, so that its coordinates are where it stands."""
        scale = self.scale
        body = spec.worldbody.add_body(name="character", pos=self.in_view((0.0, 0.0, 0.0)))
        for axis in AXES:
            body.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE, axis=axis)
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=AXES[2])
        trunk = (TALL - 2 * HEAD) * scale / 2
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_CAPSULE,
            size=(BODY * scale, trunk - BODY * scale, 0),
            pos=(0, 0, trunk),
            rgba=AGENT_COLOUR,
        )
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            size=(HEAD * scale, 0, 0),
            pos=(0, 0, (TALL - HEAD) * scale),
            rgba=(0.95, 0.8, 0.68, 1),
        )
        nose = (0.1 * scale, 0.06 * scale, 0.06 * scale)
        _box(body, nose, (0.9, 0.6, 0.5, 1), (HEAD * scale, 0, (TALL - HEAD) * scale))

    def _add_door(self, spec: mujoco.MjSpec, node: Node) -> None:
        """A leaf before the side that faces the room, on a hinge at its left edge."""
        solid, room = self.layout.solids[node.id], self.layout.room_solid(node)
        sideways = abs(room.centre[0] - solid.centre[0]) - abs(room.centre[1] - solid.centre[1])
        x, y, z = solid.centre
        width, depth, height = solid.size
        leaf = 0.02
        if sideways > 0:
            face = x + (1 if room.centre[0] > x else -1) * (width + leaf) / 2
            hinge, size, offset = (face, y - depth / 2, z), (leaf, depth, height), (0, depth / 2, 0)
        else:
            face = y + (1 if room.centre[1] > y else -1) * (depth + leaf) / 2
            hinge, size, offset = (x - width / 2, face, z), (width, leaf, height), (width / 2, 0, 0)
        body = spec.worldbody.add_body(name=f"door of {node.id}", pos=self.in_view(hinge))
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=AXES[2])
        scaled = tuple(side * self.scale for side in size)
        _box(body, scaled, DOOR_COLOUR, tuple(each * self.scale for each in offset))

    def _add_lamp(
        self, parent: mujoco.MjsBody, node: Node, place: tuple[float, float, float]
    ) -> None:
        """A light that hides in the thing and stands above it while it is on."""
        body = parent.add_body(name=f"light of {node.id}", pos=place)
        body.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE, axis=AXES[2])
        radius = min(0.05, 0.45 * min(self.layout.solids[node.id].size)) * self.scale
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=(radius, 0, 0), rgba=LAMP_COLOUR)


def _corners(solid: Solid) -> tuple[np.ndarray, np.ndarray]:
    centre, half = np.array(solid.centre[:2]), np.array(solid.size[:2]) / 2
    return centre - half, centre + half


def _box(
    body: mujoco.MjsBody,
    size: tuple[float, ...],
    colour: tuple[float, ...],
    place: tuple[float, ...],
) -> None:
    half = [max(side / 2, 1e-4) for side in size]
    body.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX, size=half, pos=place, rgba=colour, contype=0, conaffinity=0
    )


def _colour(node: Node) -> tuple[float, float, float, float]:
    """Told by the class name; what can be looked into is half clear."""
    digest = hashlib.sha256(node.name.encode()).digest()
    low, span = (0.35, 0.6) if "GRABBABLE" in node.properties else (0.5, 0.35)
    red, green, blue = (low + span * byte / 255 for byte in digest[:3])
    clear = "CONTAINERS" in node.properties and "CAN_OPEN" in node.properties
    return red, green, blue, 0.45 if clear else 1.0
