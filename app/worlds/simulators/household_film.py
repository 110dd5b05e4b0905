"""HouseholdFilm: what a rollout in a home looks like, moment by moment."""

import math
from collections.abc import Sequence

import numpy as np

from app.domain.trace import Frame
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node
from app.worlds.simulators.household_layout import Point, Solid
from app.worlds.simulators.household_model import HomeModel
from app.worlds.simulators.household_reel import HouseholdReel
from app.worlds.simulators.household_route import Spot, doors_between

PACE = 1.5
"""How fast the agent walks [m/s]."""
TURN, MOMENT = 0.3, 0.6
"""How long a turn takes, and everything else but walking [s]."""
BESIDE = 0.45
"""From the edge of what the agent works at to its middle [m]."""
HAND, HAND_HEIGHT = 0.32, 1.05
"""Of the hands: from the agent's middle, and above the floor [m]."""
AJAR = 1.75
"""How far an open door is turned [rad]."""


class HouseholdFilm:
    """Where the agent and the things are in the home's metres, and the reel that keeps it."""

    def __init__(self, agent: HouseholdAgent, model: HomeModel) -> None:
        """Begin with the home as it stands."""
        self._agent = agent
        self._model = model
        self._layout = model.layout
        self._now = np.zeros(model.size)
        self._put_agent(agent.graph.agent)
        for node in agent.held:
            self._update(node)
        self._show_states((*model.openable, *model.switchable))
        self._reel = HouseholdReel(self._now, model.units)

    @property
    def time(self) -> float:
        """When the last key is [s]."""
        return self._reel.time

    def rewind(self) -> None:
        """Call it time 0."""
        self._reel.rewind(self._now)

    def save(self) -> list[float]:
        """Time, the next frame's time, and coordinates as they are."""
        return [self.time, self._reel.next, *self._now.tolist()]

    def restore(self, saved: Sequence[float]) -> None:
        """Take up what ``save`` gave."""
        self._now = np.array(saved[2:])
        self._reel.rewind(self._now, *saved[:2])

    def catch_up(self) -> None:
        """Show the graph as it is now, whatever came before."""
        for node in self._model.movable:
            self._update(node)
        self._show_states((*self._model.openable, *self._model.switchable))
        self._sit()
        self.rewind()

    def approach(self, nodes: Sequence[Node]) -> None:
        """An action is about to be done with these: the agent goes to the last one."""
        if nodes:
            self._go(nodes[-1])

    def add(self, nodes: Sequence[Node]) -> None:
        """It was done."""
        for node in nodes:
            self._update(node)
        for node in self._agent.held:
            self._update(node)
        self._sit()
        self._show_states(nodes)
        self._key(MOMENT)

    def frames(self, until: float) -> tuple[Frame, ...]:
        """The frames not yet given up to a time [s]."""
        return self._reel.frames(until)

    def _key(self, seconds: float) -> None:
        self._reel.add(seconds, self._now)

    def _go(self, target: Node) -> None:
        """Walk to where the target can be reached, through the doors on the way, and face it."""
        if self._agent.seated or self._agent.holds(target) or target is self._agent.node:
            return
        spot = self._beside(target)
        here = (float(self._now[0]), float(self._now[1]))
        if math.dist(here, spot) < 0.3:
            return
        self._walk(here, spot)
        if target.id in self._layout.solids and not target.is_room:
            x, y, _ = self._solid(target).centre
            self._turn(math.atan2(y - self._now[1], x - self._now[0]))

    def _walk(self, here: Spot, spot: Spot) -> None:
        for point in (*doors_between(self._layout, here, spot), spot):
            here = (float(self._now[0]), float(self._now[1]))
            far = math.dist(here, point)
            if far < 0.05:
                continue
            self._turn(math.atan2(point[1] - here[1], point[0] - here[0]))
            self._now[:2] = point
            self._hold()
            self._key(far / PACE)

    def _turn(self, yaw: float) -> None:
        """Look that way [rad], the shorter way round."""
        by = math.remainder(yaw - float(self._now[3]), math.tau)
        if abs(by) > 0.05:
            self._now[3] += by
            self._hold()
            self._key(TURN)

    def _beside(self, target: Node) -> Spot:
        """Where the agent stands to work at the target, on the side of the room's middle."""
        if target.is_room:
            x, y, _ = self._layout.solids[target.id].centre
            return x, y
        solid = self._solid(self._fixed(target))
        room = self._layout.room_solid(target)
        away = (room.centre[0] - solid.centre[0], room.centre[1] - solid.centre[1])
        axis = 0 if abs(away[0]) > abs(away[1]) else 1
        spot = [solid.centre[0], solid.centre[1]]
        step = solid.size[axis] / 2 + BESIDE
        spot[axis] += step if away[axis] > 0 else -step
        for each in (0, 1):
            half = room.size[each] / 2 - BESIDE
            low, high = room.centre[each] - half, room.centre[each] + half
            spot[each] = min(max(spot[each], low), high)
        return spot[0], spot[1]

    def _fixed(self, node: Node) -> Node:
        """The piece of furniture that it is on or in, if any; where one stands to reach it."""
        graph = self._agent.graph
        for relation in ("ON", "INSIDE"):
            for other in graph.targets(node, relation):
                if other.id in self._layout.solids and not other.is_room:
                    return other
        return node if node.id in self._layout.solids else graph.room_of(node) or node

    def _solid(self, node: Node) -> Solid:
        """Where it is now."""
        solid = self._layout.solids[node.id]
        at = self._model.address.get(node.id)
        if at is None:
            return solid
        x, y, z = (solid.centre[k] + float(self._now[at + k]) for k in range(3))
        return Solid((x, y, z), solid.size)

    def _update(self, node: Node) -> None:
        """Bring a thing to where the graph has it, with all that is in and on it."""
        at = self._model.address.get(node.id)
        place = self._wanted(node) if at is not None else None
        if at is None or place is None:
            return
        first = self._layout.solids[node.id].centre
        wanted = np.array(place) - np.array(first)
        moved = wanted - self._now[at : at + 3]
        self._now[at : at + 3] = wanted
        for inner in self._agent.graph.contents(node):
            inner_at = self._model.address.get(inner.id)
            if inner_at is not None:
                self._now[inner_at : inner_at + 3] += moved

    def _wanted(self, node: Node) -> Point | None:
        """Where it should be now; None where it may stay."""
        graph = self._agent.graph
        if self._agent.holds(node):
            return self._hand(0 if graph.has(graph.agent, "HOLDS_RH", node) else 1)
        for relation in ("ON", "INSIDE"):
            for other in graph.targets(node, relation):
                if other.id in self._layout.solids and not other.is_room:
                    solid = self._solid(other)
                    if self._stands(node, solid):
                        return None
                    place = len(graph.sources(other, relation)) - 1
                    inside = relation == "INSIDE"
                    return self._layout.spot(node, other, solid, inside=inside, place=place)
        x, y, _ = self._solid(node).centre
        return x, y, self._layout.solids[node.id].size[2] / 2

    def _stands(self, node: Node, solid: Solid) -> bool:
        """Whether it is over the solid's base already, so that it need not be put anew."""
        here = self._solid(node).centre
        beside = (abs(here[k] - solid.centre[k]) <= solid.size[k] / 2 + 0.02 for k in (0, 1))
        return all(beside) and not self._in_air(here, solid)

    def _in_air(self, here: Point, solid: Solid) -> bool:
        return any(math.dist(here, self._hand(side)) < 0.02 for side in (0, 1)) and bool(solid)

    def _hand(self, side: int) -> Point:
        """The middle of the right hand (0) or the left one (1)."""
        x, y, z, yaw = (float(each) for each in self._now[:4])
        turn = yaw + (-0.6 if side == 0 else 0.6)
        return x + HAND * math.cos(turn), y + HAND * math.sin(turn), z + HAND_HEIGHT

    def _hold(self) -> None:
        for node in self._agent.held:
            self._update(node)

    def _put_agent(self, node: Node) -> None:
        room = self._layout.room_solid(node)
        x, y, _ = room.centre
        if node.box:
            x, y = node.box.centre[0], node.box.centre[2]
        self._now[:4] = (x, y, 0.0, 0.0)

    def _sit(self) -> None:
        """On the seat, if the agent sits; else on the floor."""
        graph = self._agent.graph
        seats = [e for e in graph.targets(graph.agent, "ON") if e.id in self._layout.solids]
        if not self._agent.seated or not seats:
            self._now[2] = 0.0
            return
        solid = self._solid(seats[0])
        self._now[:3] = (solid.centre[0], solid.centre[1], min(solid.top, 0.5) - 0.25)

    def _show_states(self, nodes: Sequence[Node]) -> None:
        for node in nodes:
            door = self._model.door_address.get(node.id)
            if door is not None:
                self._now[door] = AJAR if "OPEN" in node.states else 0.0
            lamp = self._model.lamp_address.get(node.id)
            if lamp is not None:
                height = self._layout.solids[node.id].size[2] / 2
                self._now[lamp] = height + 0.08 if "ON" in node.states else 0.0
