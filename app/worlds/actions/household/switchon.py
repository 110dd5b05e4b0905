from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("switchon")
class SwitchOn:
    """Let it run."""

    signature = ActionSignature(
        name="switchon",
        parameters=(Parameter(name="obj", affordance="has_switch"),),
        meaning="Switch obj on.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "HAS_SWITCH", "switch on")
        agent.demand_close(node)
        agent.demand_state(node, "OFF", verb="")
        if "PLUGGED_OUT" in node.states:
            agent.demand_state(node, "PLUGGED_IN", verb="plugin")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "OFF", "ON")
