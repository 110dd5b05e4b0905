"""HouseholdGraph: the things of a home with their states, and how they stand to one another."""

import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

AGENT = "character"
"""Class name of the one who acts."""
ROOMS = "Rooms"
"""Category of the nodes that are rooms."""
BUILT_CATEGORIES = frozenset(
    ("Rooms", "Walls", "Floor", "Floors", "Ceiling", "Doors", "Windows", "Characters")
)
"""What a home is built of, and who is in it."""
HANDS = ("HOLDS_RH", "HOLDS_LH")
"""From the agent to what is in a hand; the right hand is filled first."""
RELATIONS = ("ON", "INSIDE", "BETWEEN", "CLOSE", "FACING", *HANDS)

Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Box:
    """A bounding box along the axes of VirtualHome: x and z along the floor, y up [m]."""

    centre: Triple
    size: Triple


@dataclass(slots=True, kw_only=True, eq=False)
class Node:
    """One thing; only its states change."""

    id: int
    name: str
    """What it is called, as all of its class are: ``apple``."""
    category: str = ""
    properties: frozenset[str] = frozenset()
    """What can be done with it: ``GRABBABLE``, ``CAN_OPEN`` and so on."""
    states: set[str]
    box: Box | None = None

    @property
    def is_room(self) -> bool:
        """Whether it is a room."""
        return self.category == ROOMS

    def __str__(self) -> str:
        return self.name


class HouseholdGraph:
    """Nodes by id and by name, and edges by relation in both directions."""

    def __init__(self, nodes: Iterable[Node], edges: Iterable[tuple[int, str, int]]) -> None:
        """Take nodes of different ids, one of them the agent, and edges between them."""
        self.nodes = {node.id: node for node in nodes}
        self._named: dict[str, tuple[Node, ...]] = {}
        for node in self.nodes.values():
            self._named[node.name] = (*self._named.get(node.name, ()), node)
        self.agent = self._named[AGENT][0]
        self._clear()
        for source, relation, target in edges:
            self._ahead[relation].setdefault(source, set()).add(target)
            self._back[relation].setdefault(target, set()).add(source)

    def _clear(self) -> None:
        self._ahead: dict[str, dict[int, set[int]]] = {relation: {} for relation in RELATIONS}
        self._back: dict[str, dict[int, set[int]]] = {relation: {} for relation in RELATIONS}

    @property
    def names(self) -> Iterable[str]:
        """Every class name, in the order of first appearance."""
        return self._named

    def named(self, name: str) -> tuple[Node, ...]:
        """All of this class; of ``plate 2`` only the second one."""
        found = self._named.get(name)
        if found is None and (numbered := _NUMBERED.fullmatch(name)):
            place = int(numbered["number"]) - 1
            found = self._named.get(numbered["name"], ())[place : place + 1]
        return found or ()

    def targets(self, source: Node, relation: str) -> list[Node]:
        """What ``source`` is so related to, by ascending id."""
        found = self._ahead[relation].get(source.id)
        return [self.nodes[each] for each in sorted(found)] if found else []

    def sources(self, target: Node, relation: str) -> list[Node]:
        """What is so related to ``target``, by ascending id."""
        found = self._back[relation].get(target.id)
        return [self.nodes[each] for each in sorted(found)] if found else []

    def ids(self, source: Node, relation: str) -> set[int]:
        """Ids of what ``source`` is so related to; not to be changed."""
        return self._ahead[relation].get(source.id, _NONE)

    def has(self, source: Node, relation: str, target: Node) -> bool:
        """Whether there is this edge."""
        found = self._ahead[relation].get(source.id)
        return found is not None and target.id in found

    def add(self, source: Node, relation: str, target: Node) -> None:
        """Let there be this edge."""
        self._ahead[relation].setdefault(source.id, set()).add(target.id)
        self._back[relation].setdefault(target.id, set()).add(source.id)

    def bring_close(self, one: Node, other: Node) -> None:
        """Let each be close to the other."""
        self.add(one, "CLOSE", other)
        self.add(other, "CLOSE", one)

    def remove(self, source: Node, relation: str, target: Node) -> None:
        """Let there be no such edge."""
        self._ahead[relation].get(source.id, _NONE).discard(target.id)
        self._back[relation].get(target.id, _NONE).discard(source.id)

    def detach(self, node: Node, relations: Iterable[str], *, both_ways: bool = True) -> None:
        """Let the node stand in none of these relations to anything, nor anything to it."""
        for relation in relations:
            ahead, back = self._ahead[relation], self._back[relation]
            for other in ahead.pop(node.id, _NONE):
                back[other].discard(node.id)
            if both_ways:
                for other in back.pop(node.id, _NONE):
                    ahead[other].discard(node.id)

    def change(self, node: Node, before: str, after: str) -> None:
        """Let the node, which may be in one state, be in another."""
        node.states.discard(before)
        node.states.add(after)

    def room_of(self, node: Node) -> Node | None:
        """The room it is in, if it is in any."""
        seen: set[int] = set()
        while not node.is_room and node.id not in seen:
            seen.add(node.id)
            around = self.targets(node, "INSIDE")
            room = next((each for each in around if each.is_room), None)
            if room is not None:
                return room
            if not around:
                return None
            node = around[0]
        return node if node.is_room else None

    def contents(self, node: Node) -> Iterator[Node]:
        """Everything that is in or on the node, and in or on that."""
        waiting, seen = [node], {node.id}
        while waiting:
            each = waiting.pop()
            for inner in (*self.sources(each, "INSIDE"), *self.sources(each, "ON")):
                if inner.id not in seen:
                    seen.add(inner.id)
                    waiting.append(inner)
                    yield inner

    def edges(self) -> Iterator[tuple[int, str, int]]:
        """Every edge: from, relation, to; in a fixed order."""
        for relation in RELATIONS:
            for source, targets in sorted(self._ahead[relation].items()):
                for target in sorted(targets):
                    yield source, relation, target

    def save(self) -> str:
        """All that may change, as JSON."""
        states = [[node.id, *sorted(node.states)] for node in self.nodes.values() if node.states]
        return json.dumps([states, list(self.edges())])

    def restore(self, saved: str) -> None:
        """Take up what ``save`` gave."""
        states, edges = json.loads(saved)
        for node in self.nodes.values():
            node.states.clear()
        for identifier, *names in states:
            self.nodes[identifier].states.update(names)
        self._clear()
        for source, relation, target in edges:
            self.add(self.nodes[source], relation, self.nodes[target])


_NONE: set[int] = set()
_NUMBERED = re.compile(r"(?P<name>.+) (?P<number>[1-9][0-9]{0,3})")
