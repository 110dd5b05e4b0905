"""Walking: what the verbs have in common that bring the agent somewhere on its feet."""

from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


class Walking:
    """Leave where one stands, and be close to the thing or in the room."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        agent.demand_standing()
        (node,) = nodes
        if agent.graph.room_of(node) is None:
            refuse(f"there is no way to the {node}")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        room = agent.graph.room_of(node)
        assert room is not None  # checked
        agent.walk_to(node, room)
