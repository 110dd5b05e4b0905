"""What is true of a home, at the level of class names: any apple will do for ``apple``."""

from collections.abc import Callable, Iterator

from app.domain.condition import Relation
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_goals import OF_ONE, OF_TWO
from app.worlds.simulators.household_graph import BUILT_CATEGORIES, HouseholdGraph, Node

RELATIONS: dict[str, int] = {
    **dict.fromkeys(OF_TWO.values(), 2),
    **dict.fromkeys(OF_ONE.values(), 1),
    "near": 1,
    "held": 1,
}
"""``near(a)``: the agent is close enough to a to use it; ``close(a, b)``: the two are."""

_STATE = {relation: state for state, relation in OF_ONE.items()}
_EDGE = {relation: edge for edge, relation in OF_TWO.items()}
_NOT_TOLD = ("SITTING", "LYING")


def holds(agent: HouseholdAgent, relation: Relation) -> bool:
    """Whether it is true of any things of these names."""
    graph = agent.graph
    if len(relation.arguments) == 1:
        decide = _of_one(relation.name, agent)
        return decide is not None and any(map(decide, graph.named(relation.arguments[0])))
    if len(relation.arguments) != 2 or relation.name not in _EDGE:
        return False
    (one, other), edge = relation.arguments, _EDGE[relation.name]
    places = set(graph.named(other))
    for node in graph.named(one):
        found = _within(graph, node) if edge == "INSIDE" else graph.targets(node, edge)
        if any(each in places for each in found):
            return True
    return False


def _within(graph: HouseholdGraph, node: Node) -> Iterator[Node]:
    """All that it is inside of, directly or in something that is."""
    seen: set[int] = set()
    waiting = graph.targets(node, "INSIDE")
    while waiting:
        around = waiting.pop(0)
        if around.id not in seen:
            seen.add(around.id)
            yield around
            waiting += graph.targets(around, "INSIDE")


def facts(agent: HouseholdAgent) -> Iterator[Relation]:
    """What is true and worth telling: states, what is held, and what is in or on what."""
    graph = agent.graph
    for node in graph.nodes.values():
        for state in node.states:
            if state in OF_ONE and state not in _NOT_TOLD:
                yield Relation(OF_ONE[state], (node.name,))
        if node.category not in BUILT_CATEGORIES:
            yield from _places(graph, node)
    for node in agent.held:
        yield Relation("held", (node.name,))
    if agent.seated:
        yield Relation("sitting" if "SITTING" in agent.node.states else "lying", (agent.node.name,))


def _places(graph: HouseholdGraph, node: Node) -> Iterator[Relation]:
    around = graph.targets(node, "INSIDE")
    inner = [each for each in around if not each.is_room]
    for each in inner or around:
        yield Relation("in", (node.name, each.name))
    for each in graph.targets(node, "ON"):
        if each.category not in BUILT_CATEGORIES:
            yield Relation("on", (node.name, each.name))


def _of_one(name: str, agent: HouseholdAgent) -> Callable[[Node], bool] | None:
    if name == "near":
        return agent.is_close
    if name == "held":
        return agent.holds
    state = _STATE.get(name)
    if state is None:
        return None
    if state in _NOT_TOLD:
        return lambda node: (
            state in agent.node.states
            and (node is agent.node or agent.graph.has(agent.node, "ON", node))
        )
    return lambda node: state in node.states
