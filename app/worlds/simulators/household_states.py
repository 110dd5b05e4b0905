"""Heated, washed, used: states that come of other states, and stay."""

from app.worlds.simulators.household_graph import HouseholdGraph, Node

FOOD = "Food"
PHONES = ("wallphone", "cellphone", "telephone")
OVENS = ("microwave", "toaster", "stove", "oven")
"""What is in one of these while it is on gets hot."""
PANS = ("fryingpan", "cookingpot", "oventray")
"""What is in or on one of these on a stove that is on gets hot."""
WASHERS = ("washingmachine", "dishwasher")


def derive(graph: HouseholdGraph, *, official: bool = False) -> None:
    """Add the states that follow from how things stand now.

    The ``official`` rules are those of the paper's release: only a microwave and a frying pan on a
    stove heat, only the category Food, what is *on* the pan; only a washing machine and a sink
    wash; only the telephone on the wall is used.
    """
    for phone in _running(graph, PHONES[:1] if official else PHONES):
        phone.states.add("USED")
    for oven in _running(graph, OVENS[:1] if official else OVENS):
        _heat(graph.sources(oven, "INSIDE"), official)
    for stove in _running(graph, ("stove",)):
        _heat(_in_pans(graph, stove, official), official)
    for washer in (*_running(graph, WASHERS[:1] if official else WASHERS), *_sinks(graph)):
        for node in graph.sources(washer, "INSIDE"):
            node.states.add("WASHED")


def _running(graph: HouseholdGraph, names: tuple[str, ...]) -> list[Node]:
    return [node for name in names for node in graph.named(name) if "ON" in node.states]


def _heat(found: list[Node], official: bool) -> None:
    for node in found:
        if node.category == FOOD or (not official and "EATABLE" in node.properties):
            node.states.add("HEATED")


def _in_pans(graph: HouseholdGraph, stove: Node, official: bool) -> list[Node]:
    names = PANS[:1] if official else PANS
    pans = [each for each in graph.sources(stove, "ON") if each.name in names]
    relations = ("ON",) if official else ("ON", "INSIDE")
    return [each for pan in pans for relation in relations for each in graph.sources(pan, relation)]


def _sinks(graph: HouseholdGraph) -> list[Node]:
    """Those in a room where a faucet runs."""
    rooms = {_room(graph, faucet) for faucet in _running(graph, ("faucet",))}
    return [each for each in graph.named("sink") if _room(graph, each) in rooms] if rooms else []


def _room(graph: HouseholdGraph, node: Node) -> int | None:
    room = graph.room_of(node)
    return room.id if room else None
