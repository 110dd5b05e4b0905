from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import OPENABLE, HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("open")
class Open:
    """Open it with a free hand; what runs stays shut."""

    signature = ActionSignature(
        name="open",
        parameters=(Parameter(name="obj", affordance="can_open"),),
        meaning="Open obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if node.name not in OPENABLE:
            agent.demand_property(node, "CAN_OPEN", "open")
        agent.demand_close(node)
        agent.demand_free_hand()
        agent.demand_state(node, "CLOSED", verb="")
        if "ON" in node.states:
            agent.demand_state(node, "OFF", verb="switchoff")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "CLOSED", "OPEN")
