from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("watch")
class Watch(Unchanging):
    """Watch what is faced in the same room."""

    signature = ActionSignature(
        name="watch",
        parameters=(Parameter(name="obj", affordance="lookable"),),
        meaning="Watch obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "LOOKABLE", "watch")
        if agent.graph.room_of(node) is not agent.room():
            agent.demand_close(node)
        agent.demand_facing(node)
