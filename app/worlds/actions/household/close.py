from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import OPENABLE, HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("close")
class Close:
    """Close it; no hand is needed."""

    signature = ActionSignature(
        name="close",
        parameters=(Parameter(name="obj", affordance="can_open"),),
        meaning="Close obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if node.name not in OPENABLE:
            agent.demand_property(node, "CAN_OPEN", "close")
        agent.demand_close(node)
        agent.demand_state(node, "OPEN", verb="")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "OPEN", "CLOSED")
