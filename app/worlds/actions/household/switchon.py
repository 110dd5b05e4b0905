from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_switching import Switching
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("switchon")
class SwitchOn(Switching):
    """Let it run."""

    signature = ActionSignature(
        name="switchon",
        parameters=(Parameter(name="obj", affordance="has_switch"),),
        meaning="Switch obj on.",
    )
    needed, verb = "HAS_SWITCH", "switch on"
    before, after = "OFF", "ON"

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        super().check(agent, *nodes)
        (node,) = nodes
        if "PLUGGED_OUT" in node.states:
            agent.demand_state(node, "PLUGGED_IN", verb="plugin")
