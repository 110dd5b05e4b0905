from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("switchoff")
class SwitchOff:
    """Let it rest."""

    signature = ActionSignature(
        name="switchoff",
        parameters=(Parameter(name="obj", affordance="has_switch"),),
        meaning="Switch obj off.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "HAS_SWITCH", "switch off")
        agent.demand_close(node)
        agent.demand_state(node, "ON", verb="")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "ON", "OFF")
