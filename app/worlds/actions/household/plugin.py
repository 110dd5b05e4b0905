from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("plugin")
class PlugIn:
    """Plug it in."""

    signature = ActionSignature(
        name="plugin",
        parameters=(Parameter(name="obj", affordance="has_plug"),),
        meaning="Plug obj in.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "HAS_PLUG", "plug in")
        agent.demand_close(node)
        agent.demand_free_hand()
        agent.demand_state(node, "PLUGGED_OUT", verb="")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "PLUGGED_OUT", "PLUGGED_IN")
