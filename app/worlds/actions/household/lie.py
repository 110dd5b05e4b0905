from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node

BERTHS = {"couch": 2, "sofa": 2, "bed": 3, "bathtub": 2, "loveseat": 2}
"""How much may be on it; one where it is not listed."""


@actions.register("lie")
class Lie:
    """Lie down on it, if there is room."""

    signature = ActionSignature(
        name="lie",
        parameters=(Parameter(name="obj", affordance="lieable"),),
        meaning="Lie down on obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "LIEABLE", "lie on")
        agent.demand_close(node)
        if "LYING" in agent.node.states:
            agent.demand_standing()
        if len(agent.graph.sources(node, "ON")) >= BERTHS.get(node.name, 1):
            refuse(f"there is no room left on the {node}")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.node.states.discard("SITTING")
        agent.node.states.add("LYING")
        agent.graph.add(agent.node, "ON", node)
