"""Homes as JSON: VirtualHome's own graphs, or the compact rows of the paper's data, to a graph."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from app.domain.errors import Fault, SceneRefused
from app.worlds.simulators.household_graph import AGENT, RELATIONS, ROOMS, Box, HouseholdGraph, Node

PROPERTIES = frozenset(
    [
        "SURFACES",
        "GRABBABLE",
        "SITTABLE",
        "LIEABLE",
        "HANGABLE",
        "DRINKABLE",
        "EATABLE",
        "RECIPIENT",
        "CUTTABLE",
        "POURABLE",
        "CAN_OPEN",
        "HAS_SWITCH",
        "READABLE",
        "LOOKABLE",
        "CONTAINERS",
        "CLOTHES",
        "PERSON",
        "BODY_PART",
        "COVER_OBJECT",
        "HAS_PLUG",
        "HAS_PAPER",
        "MOVABLE",
        "CREAM",
    ]
)
STATES = frozenset(
    [
        "CLOSED",
        "OPEN",
        "ON",
        "OFF",
        "SITTING",
        "DIRTY",
        "CLEAN",
        "LYING",
        "PLUGGED_IN",
        "PLUGGED_OUT",
        "HEATED",
        "WASHED",
        "USED",
    ]
)
Document = Mapping[str, Any]


def read_graph(
    document: Document, *, close: Iterable[int] = (), field: str = "scene.graph"
) -> HouseholdGraph:
    """The graph of a document with ``nodes`` and ``edges``.

    Nodes are objects (id, class_name, category, properties, states, bounding_box) or rows of the
    same in this order; edges are objects (from_id, relation_type, to_id) or rows. A document may
    tell the ``agent_room`` instead of having an edge for it. The agent begins close to what
    ``close`` names. What is neither OPEN nor CLOSED can be neither opened nor closed.

    Raises:
        SceneRefused: it is no home; every fault names its place below ``field``.
    """
    nodes, faults = _nodes(document, field)
    known = {node.id for node in nodes}
    faults += list(_node_faults(nodes, field))
    edges = [_edge(each) for each in document["edges"]]
    faults += list(_edge_faults(edges, known, field))
    if faults:
        raise SceneRefused(*faults)
    graph = HouseholdGraph(nodes, edges)
    if "agent_room" in document and not graph.ids(graph.agent, "INSIDE"):
        graph.add(graph.agent, "INSIDE", graph.nodes[document["agent_room"]])
    for identifier in close:
        graph.bring_close(graph.agent, graph.nodes[identifier])
    if graph.room_of(graph.agent) is None:
        message = f"the {AGENT} is in no room; give it an INSIDE edge to one"
        raise SceneRefused(Fault(field=f"{field}.edges", message=message))
    return graph


def _nodes(document: Document, field: str) -> tuple[list[Node], list[Fault]]:
    found: list[Node] = []
    faults: list[Fault] = []
    for index, given in enumerate(document["nodes"]):
        node = _node(given)
        found.append(node)
        for noun, names, known in (
            ("property", node.properties, PROPERTIES),
            ("state", node.states, STATES),
        ):
            for name in sorted(names - known):
                message = f"there is no {noun} {name[:40]!r}; known: {', '.join(sorted(known))}"
                faults.append(Fault(field=f"{field}.nodes.{index}", message=message))
    return found, faults


def _node(given: Document | Sequence[Any]) -> Node:
    if not isinstance(given, Mapping):
        keys = ("id", "class_name", "category", "properties", "states")
        given = dict(zip(keys, given, strict=False))
    return Node(
        id=given["id"],
        name=given["class_name"],
        category=given.get("category") or "",
        properties=frozenset(given.get("properties") or ()),
        states=set(given.get("states") or ()),
        box=_box(given.get("bounding_box")),
    )


def _box(given: Document | None) -> Box | None:
    return Box(tuple(given["center"]), tuple(given["size"])) if given else None


def _edge(given: Document | Sequence[Any]) -> tuple[int, str, int]:
    if isinstance(given, Mapping):
        return given["from_id"], given["relation_type"], given["to_id"]
    source, relation, target = given
    return source, relation, target


def _node_faults(nodes: list[Node], field: str) -> Iterator[Fault]:
    seen: set[int] = set()
    for index, node in enumerate(nodes):
        if node.id in seen:
            message = f"the id {node.id} is another node's already"
            yield Fault(field=f"{field}.nodes.{index}.id", message=message)
        seen.add(node.id)
    agents = sum(node.name == AGENT for node in nodes)
    if agents != 1:
        message = f"has {agents} nodes of class {AGENT!r}; there is one who acts"
        yield Fault(field=f"{field}.nodes", message=message)
    if not any(node.is_room for node in nodes):
        yield Fault(field=f"{field}.nodes", message=f"has no room, a node of category {ROOMS!r}")


def _edge_faults(edges: list[tuple[int, str, int]], known: set[int], field: str) -> Iterator[Fault]:
    for index, (source, relation, target) in enumerate(edges):
        place = f"{field}.edges.{index}"
        if relation not in RELATIONS:
            message = f"there is no relation {relation[:40]!r}; known: {', '.join(RELATIONS)}"
            yield Fault(field=f"{place}.relation_type", message=message)
        for name, end in (("from_id", source), ("to_id", target)):
            if end not in known:
                yield Fault(field=f"{place}.{name}", message=f"there is no node of id {end}")
