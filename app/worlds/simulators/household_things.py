"""The classes of things in a home, as planners and the catalogue are told of them."""

from app.domain.scene import SceneObject
from app.domain.world import ObjectKind
from app.worlds.simulators.household_agent import OPENABLE
from app.worlds.simulators.household_graph import AGENT, HouseholdGraph, Node

_HOLDING = frozenset(("CONTAINERS", "SURFACES", "RECIPIENT"))


def things(graph: HouseholdGraph) -> tuple[SceneObject, ...]:
    """One for each class, rooms and all, as the paper lists them."""
    return tuple(_described(graph, name) for name in sorted(graph.names) if name != AGENT)


def _described(graph: HouseholdGraph, name: str) -> SceneObject:
    nodes = graph.named(name)
    first = nodes[0]
    affordances = sorted({each for node in nodes for each in node.properties} | _ways(name))
    properties = [("affordances", " ".join(affordances).lower())] if affordances else []
    rooms = {room.name for node in nodes if (room := graph.room_of(node)) and room is not node}
    if rooms:
        properties.append(("room", " ".join(sorted(rooms))))
    if places := [place for node in nodes if (place := _place(graph, node))]:
        properties.append(("place", " ".join(places)))
    if len(nodes) > 1:
        properties.append(("number", str(len(nodes))))
    return SceneObject(
        name=name,
        kind=name,
        category=_category(first),
        container=bool(first.properties & _HOLDING),
        properties=tuple(properties),
    )


def _place(graph: HouseholdGraph, node: Node) -> str:
    """What it is inside of or on, of what can be taken: "it was in the fridge"."""
    if "GRABBABLE" not in node.properties:
        return ""
    around = (*graph.targets(node, "INSIDE"), *graph.targets(node, "ON"))
    inner = [each for each in around if not each.is_room]
    return inner[0].name if inner else "floor"


def _ways(name: str) -> set[str]:
    """What it affords though its properties do not say so."""
    return {"CAN_OPEN"} if name in OPENABLE else set()


def _category(node: Node) -> str:
    return "room" if node.is_room else node.category.lower() or "thing"


def kind(node: Node) -> ObjectKind:
    """An entry of the catalogue, as large as this one is."""
    size = node.box.size if node.box else (0.1, 0.1, 0.1)
    return ObjectKind(
        name=node.name,
        category=_category(node),
        synonyms=(),
        container=bool(node.properties & _HOLDING),
        size=(size[0], size[2], size[1]),
        colour="#888888",
    )
