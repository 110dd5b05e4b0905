"""HouseholdAgent: what the one who acts in a home can reach, hold and demand."""

from typing import NoReturn

from app.domain.errors import ActionFailure
from app.domain.program import ActionCall
from app.worlds.simulators.household_graph import HANDS, HouseholdGraph, Node

POSTURES = ("SITTING", "LYING")
OPENABLE = frozenset({"desk", "window"})
"""Can be opened, whatever their properties say."""


class HouseholdAgent:
    """The agent of a graph.

    What it cannot do it says in an ``ActionFailure``, with the calls that would help. The
    ``official`` rules keep oddities of the reference simulator, for its tables: what is carried
    stays in the room left before, what is lifted loses what is in and on it, and who stands up
    is still on the chair.
    """

    def __init__(self, graph: HouseholdGraph, *, official: bool = False) -> None:
        self.graph = graph
        self.official = official

    @property
    def node(self) -> Node:
        """The agent itself."""
        return self.graph.agent

    @property
    def held(self) -> list[Node]:
        """What is in its hands, right before left."""
        return [node for hand in HANDS for node in self.graph.targets(self.node, hand)]

    @property
    def seated(self) -> bool:
        """Whether it sits or lies."""
        return any(posture in self.node.states for posture in POSTURES)

    def holds(self, node: Node) -> bool:
        """Whether the node is in a hand."""
        return any(self.graph.has(self.node, hand, node) for hand in HANDS)

    def free_hand(self) -> str | None:
        """The relation to what it takes next, if a hand is free."""
        return next((hand for hand in HANDS if not self.graph.ids(self.node, hand)), None)

    def is_close(self, node: Node) -> bool:
        """Close to it, to something that is close to it, or to something it is on."""
        near = self.graph.ids(self.node, "CLOSE")
        if node.id in near:
            return True
        beside = any(self.graph.has(self.graph.nodes[each], "CLOSE", node) for each in near)
        return beside or not near.isdisjoint(self.graph.ids(node, "ON"))

    def faces(self, node: Node) -> bool:
        """Turned to it, or to something that faces it."""
        if self.graph.has(self.node, "FACING", node):
            return True
        before = self.graph.targets(self.node, "FACING")
        return any(self.graph.has(each, "FACING", node) for each in before)

    def shut_in(self, node: Node) -> Node | None:
        """The closed thing it is inside, if there is one."""
        around = self.graph.targets(node, "INSIDE")
        return next((e for e in around if "CLOSED" in e.states and not e.is_room), None)

    def room(self) -> Node | None:
        """Where the agent is."""
        return self.graph.room_of(self.node)

    def demand_close(self, node: Node) -> None:
        """Raises ActionFailure: the agent is not close to it."""
        if not self.is_close(node):
            _fail(f"the agent is not close to the {node}", *self.to_reach(node))

    def demand_standing(self) -> None:
        """Raises ActionFailure: the agent sits or lies."""
        if self.seated:
            _fail("the agent sits or lies", _call("standup"))

    def demand_property(self, node: Node, name: str, verb: str) -> None:
        """Raises ActionFailure: this cannot be done with it, and nothing would help."""
        if name not in node.properties:
            _fail(f"nobody can {verb} the {node}")

    def demand_reachable(self, node: Node) -> None:
        """Raises ActionFailure: it is shut in."""
        shut = self.shut_in(node)
        if shut is not None:
            _fail(f"the {node} is inside the closed {shut}", *self.to_reach(shut), _opened(shut))

    def demand_free_hand(self) -> None:
        """Raises ActionFailure: both hands are full."""
        if self.free_hand() is None:
            names = " and the ".join(each.name for each in self.held)
            _fail(f"both hands are full, of the {names}", *self._to_empty_a_hand())

    def demand_held(self, node: Node) -> None:
        """Raises ActionFailure: it is in no hand."""
        if not self.holds(node):
            shut = self.shut_in(node)
            opening = (*self.to_reach(shut), _opened(shut)) if shut else ()
            calls = (*opening, *self.to_reach(node), _call("grab", node))
            _fail(f"the {node} is not in the agent's hands", *calls)

    def demand_facing(self, node: Node) -> None:
        """Raises ActionFailure: the agent is not turned to it."""
        if not self.faces(node):
            _fail(f"the agent does not face the {node}", _call("turnto", node))

    def demand_open(self, node: Node) -> None:
        """Raises ActionFailure: it can be opened and is not open."""
        if "CAN_OPEN" in node.properties and "OPEN" not in node.states:
            first = (_call("switchoff", node),) if "ON" in node.states else ()
            _fail(f"the {node} is closed", *self.to_reach(node), *first, _opened(node))

    def demand_state(self, node: Node, state: str, *, verb: str) -> None:
        """Raises ActionFailure: it is not in this state; ``verb`` brings it about.

        Without a verb it is in the other state, which the action would bring about.
        """
        if state not in node.states:
            remedy = (_call(verb, node),) if verb else ()
            reason = f"the {node} is not {state.lower()}"
            raise ActionFailure("check", reason, remedy=remedy, needless=not verb)

    def to_reach(self, node: Node) -> tuple[ActionCall, ...]:
        """The calls that bring the agent close to it; none where it is."""
        if self.is_close(node):
            return ()
        standing = (_call("standup"),) if self.seated else ()
        return (*standing, _call("find", node))

    def walk_to(self, node: Node, room: Node) -> None:
        """Leave what was close, and be close to the node, to what it is in and what it is on."""
        graph, me = self.graph, self.node
        left = self.room() or room
        graph.detach(me, ("INSIDE", "CLOSE", "FACING"))
        graph.add(me, "INSIDE", room)
        if node is not room:
            for around in graph.targets(node, "INSIDE"):
                if not around.is_room:
                    graph.bring_close(me, around)
            graph.bring_close(me, node)
        for item in self.held:
            self._carry(item, left if self.official else room)
        if "CAN_OPEN" in node.properties:
            for inner in graph.sources(node, "INSIDE"):
                graph.bring_close(me, inner)
        for support in graph.targets(node, "ON"):
            graph.bring_close(me, support)

    def _carry(self, item: Node, room: Node) -> None:
        graph = self.graph
        graph.detach(item, ("CLOSE", "FACING"))
        if self.official:
            graph.detach(item, ("INSIDE",))
        else:
            for inner in graph.contents(item):
                self._take_along(inner, room)
            graph.detach(item, ("INSIDE",), both_ways=False)
        graph.bring_close(self.node, item)
        graph.add(item, "INSIDE", room)

    def _take_along(self, inner: Node, room: Node) -> None:
        """What is in or on something carried comes into the same room."""
        graph = self.graph
        for around in graph.targets(inner, "INSIDE"):
            if around.is_room:
                graph.remove(inner, "INSIDE", around)
                graph.add(inner, "INSIDE", room)

    def take(self, node: Node, hand: str) -> None:
        """Lift it out of or off where it was, and stay close to that."""
        graph, me = self.graph, self.node
        stayed = self._first_around(node)
        if self.official:
            graph.detach(node, ("ON", "INSIDE", "CLOSE", *HANDS))
        else:
            graph.detach(node, ("ON", "INSIDE"), both_ways=False)
            graph.detach(node, ("CLOSE", *HANDS))
        graph.bring_close(me, node)
        graph.add(me, hand, node)
        room = self.room()
        if room is not None:
            graph.add(node, "INSIDE", room)
        if stayed is not None:
            graph.bring_close(me, stayed)

    def put(self, item: Node, relation: str, target: Node) -> None:
        """Let go of it in (``INSIDE``) or on (``ON``) the target, as that one affords."""
        graph = self.graph
        relation = self.afforded(relation, target)
        for hand in HANDS:
            graph.remove(self.node, hand, item)
        graph.bring_close(self.node, target)
        graph.bring_close(item, target)
        graph.add(item, relation, target)

    def afforded(self, relation: str, target: Node) -> str:
        """``ON`` for what only has a surface, ``INSIDE`` for what is open and has none.

        So "in the bed" and "on the garbage can" come out as they are meant; what has a door may
        also have things on top. The official rules take the word as it is.
        """
        if self.official or target.is_room or "CAN_OPEN" in target.properties:
            return relation
        inside, flat = "CONTAINERS" in target.properties, "SURFACES" in target.properties
        if inside == flat:
            return relation
        return "INSIDE" if inside else "ON"

    def let_go(self, item: Node) -> None:
        """Have it in no hand; it is in the room then."""
        for hand in HANDS:
            self.graph.remove(self.node, hand, item)
        room = self.room()
        if room is not None:
            self.graph.add(item, "INSIDE", room)

    def _first_around(self, node: Node) -> Node | None:
        for relation in ("ON", "INSIDE", "CLOSE"):
            for other in self.graph.targets(node, relation):
                if not other.is_room and (self.official or other is not self.node):
                    return other
        return None

    def _to_empty_a_hand(self) -> tuple[ActionCall, ...]:
        """Put what is in the left hand on something flat that is near."""
        item = self.held[-1]
        near = [self.graph.nodes[each] for each in sorted(self.graph.ids(self.node, "CLOSE"))]
        flat = [each for each in near if "SURFACES" in each.properties and each not in self.held]
        fixed = [each for each in flat if "GRABBABLE" not in each.properties]
        if fixed:
            return (_call("putback", item, fixed[0]),)
        room = self.room()
        inside = self.graph.sources(room, "INSIDE") if room else []
        tables = [
            e for e in inside if "SURFACES" in e.properties and "GRABBABLE" not in e.properties
        ]
        if not tables:
            return (_call("drop", item),)
        return (*self.to_reach(tables[0]), _call("putback", item, tables[0]))


def _call(verb: str, *nodes: Node) -> ActionCall:
    return ActionCall(action=verb, arguments=tuple(node.name for node in nodes))


def _opened(node: Node) -> ActionCall:
    return _call("open", node)


def _fail(reason: str, *remedy: ActionCall) -> NoReturn:
    raise ActionFailure("check", reason, remedy=remedy)


def refuse(reason: str) -> NoReturn:
    """Raises ActionFailure: it cannot be done, and no call would help."""
    _fail(reason)
