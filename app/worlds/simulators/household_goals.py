"""The paper's goal conditions: what a demonstration made true of a home."""

from collections.abc import Iterator

from app.domain.condition import Condition, Relation
from app.worlds.simulators.household_graph import HANDS, HouseholdGraph

Fact = tuple[str, str, str] | tuple[str, str]
"""At the level of classes: ``("apple", "INSIDE", "fridge")``, ``("fridge", "OPEN")``."""

OF_ONE = {
    "OPEN": "open",
    "CLOSED": "closed",
    "ON": "switched_on",
    "OFF": "switched_off",
    "HEATED": "heated",
    "WASHED": "washed",
    "USED": "used",
    "CLEAN": "clean",
    "SITTING": "sitting",
    "LYING": "lying",
}
"""States, and the relation of one object that tells them."""
OF_TWO = {"INSIDE": "in", "ON": "on", "CLOSE": "close", "FACING": "facing"}
"""Edges, and the relation of two objects that tells them."""


def class_facts(graph: HouseholdGraph) -> frozenset[Fact]:
    """Every edge and every state, told of classes: one apple in a fridge, an apple in a fridge."""
    nodes = graph.nodes
    edges = {
        (nodes[source].name, relation, nodes[target].name)
        for source, relation, target in graph.edges()
    }
    states = {(node.name, state) for node in nodes.values() for state in node.states}
    return frozenset(edges | states)


def goal_facts(initial: HouseholdGraph, final: HouseholdGraph) -> frozenset[Fact]:
    """The official goal: facts of the final graph that are not among those of the initial one."""
    return class_facts(final) - class_facts(initial)


def is_core(fact: Fact, graph: HouseholdGraph) -> bool:
    """Whether a fact says more than where somebody stood: not CLOSE, FACING, or in which room."""
    if len(fact) == 2:
        return True
    _, relation, target = fact
    if relation in ("CLOSE", "FACING", "BETWEEN"):
        return False
    return relation != "INSIDE" or not any(node.is_room for node in graph.named(target))


def goal_conditions(
    initial: HouseholdGraph, final: HouseholdGraph, *, core: bool = False
) -> tuple[Condition, ...]:
    """What a rollout from ``initial`` has to bring about to be like ``final``, in a fixed order.

    With ``core`` without the facts that only say where somebody stood, three quarters of them.
    """
    facts = sorted(goal_facts(initial, final))
    chosen = (fact for fact in facts if not core or is_core(fact, initial))
    return tuple(dict.fromkeys(relation for fact in chosen for relation in _told(fact)))


def recall(goal: frozenset[Fact], graph: HouseholdGraph) -> float:
    """The official GCR: the share of the goal's facts that are true of the graph; 1 of no goal."""
    return len(goal & class_facts(graph)) / len(goal) if goal else 1.0


def _told(fact: Fact) -> Iterator[Relation]:
    if len(fact) == 2:
        name, state = fact
        if state in OF_ONE:
            yield Relation(OF_ONE[state], (name,))
        return
    source, relation, target = fact
    if relation in HANDS:
        yield Relation("held", (target,))
    elif relation in OF_TWO:
        yield Relation(OF_TWO[relation], (source, target))
