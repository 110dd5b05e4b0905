"""HomeLayout: where the things of a home stand, as boxes; what no box is told of is laid out."""

import math
from dataclasses import dataclass

from app.worlds.simulators.household_graph import BUILT_CATEGORIES, HouseholdGraph, Node

Point = tuple[float, float, float]
"""x, y along the floor, z up [m]."""

SMALL, LARGE = (0.12, 0.12, 0.12), (0.6, 0.6, 0.8)
"""Sizes of what can be taken and of what cannot, where none is told [m]."""
CELL = 0.9
"""Distance of furniture that is laid out [m]."""
PITCH = 0.3
"""Distance of things side by side on or in something [m]."""


@dataclass(slots=True)
class Solid:
    """A box along the axes."""

    centre: Point
    size: Point

    @property
    def top(self) -> float:
        """Height of its upper side [m]."""
        return self.centre[2] + self.size[2] / 2

    @property
    def bottom(self) -> float:
        """Height of its underside [m]."""
        return self.centre[2] - self.size[2] / 2


class HomeLayout:
    """The solids of a graph's rooms and things as they stand at first, by id."""

    def __init__(self, graph: HouseholdGraph) -> None:
        """Take the bounding boxes the graph tells, and lay out the rest."""
        self.graph = graph
        self.rooms = [node for node in graph.nodes.values() if node.is_room]
        self.things = [
            node for node in graph.nodes.values() if node.category not in BUILT_CATEGORIES
        ]
        self.doors = [node for node in graph.named("door") if node.box]
        self.solids: dict[int, Solid] = {}
        told = all(room.box for room in self.rooms)
        if told:
            for node in (*self.rooms, *self.things, *self.doors):
                if node.box:
                    self.solids[node.id] = _told(node)
        else:
            self._lay_out_rooms()
        for node in self.things:
            self._lay_out(node, set())

    def room_solid(self, node: Node) -> Solid:
        """The room it is in, or the first one."""
        return self.solids[(self.graph.room_of(node) or self.rooms[0]).id]

    def spot(self, node: Node, target: Node, at: Solid, *, inside: bool, place: int) -> Point:
        """The centre of the node as the so manieth thing on or in the target, which stands at."""
        size = self.solids[node.id].size if node.id in self.solids else _size(node)
        columns = max(1, int(at.size[0] / PITCH))
        rows = max(1, int(at.size[1] / PITCH))
        column, row = place % columns, place // columns % rows
        x = at.centre[0] - at.size[0] / 2 + at.size[0] * (column + 0.5) / columns
        y = at.centre[1] - at.size[1] / 2 + at.size[1] * (row + 0.5) / rows
        base = at.bottom + 0.05 if inside and "CONTAINERS" in target.properties else at.top
        return x, y, base + size[2] / 2 + 0.12 * (place // (columns * rows))

    def _lay_out_rooms(self) -> None:
        """Rooms side by side, each with its furniture in rows."""
        left = 0.0
        for room in self.rooms:
            standing = [
                node
                for node in self.things
                if self._support(node) is None and self.graph.room_of(node) is room
            ]
            across = max(3, math.ceil(math.sqrt(len(standing))))
            side = across * CELL + 0.6
            self.solids[room.id] = Solid((left + side / 2, side / 2, 1.25), (side, side, 2.5))
            for index, node in enumerate(standing):
                size = _size(node)
                x = left + 0.3 + CELL * (index % across + 0.5)
                y = 0.3 + CELL * (index // across + 0.5)
                self.solids[node.id] = Solid((x, y, size[2] / 2), size)
            left += side

    def _support(self, node: Node) -> tuple[Node, bool] | None:
        """What it is on or in, and whether in; not the floor, a wall or the room."""
        for relation in ("ON", "INSIDE"):
            for other in self.graph.targets(node, relation):
                if other.category not in BUILT_CATEGORIES:
                    return other, relation == "INSIDE"
        return None

    def _lay_out(self, node: Node, underway: set[int]) -> Solid:
        if node.id in self.solids:
            return self.solids[node.id]
        size = _size(node)
        support = self._support(node)
        if support is None or support[0].id in underway:
            room = self.room_solid(node)
            centre = (room.centre[0], room.centre[1], size[2] / 2)
        else:
            target, inside = support
            at = self._lay_out(target, underway | {node.id})
            relation = "INSIDE" if inside else "ON"
            place = [each.id for each in self.graph.sources(target, relation)].index(node.id)
            centre = self.spot(node, target, at, inside=inside, place=place)
        self.solids[node.id] = Solid(centre, size)
        return self.solids[node.id]


def _told(node: Node) -> Solid:
    """VirtualHome's axes to ours: its y is up."""
    assert node.box is not None
    (x, y, z), (width, height, depth) = node.box.centre, node.box.size
    return Solid((x, z, y), (max(width, 0.01), max(depth, 0.01), max(height, 0.01)))


def _size(node: Node) -> Point:
    return SMALL if "GRABBABLE" in node.properties else LARGE
