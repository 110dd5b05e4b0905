from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node

SEATS = {"couch": 4, "sofa": 4, "bed": 4, "bench": 2, "loveseat": 2, "pianobench": 2}
"""How much may be on it; one where it is not listed."""


@actions.register("sit")
class Sit:
    """Sit down on it, if there is room."""

    signature = ActionSignature(
        name="sit",
        parameters=(Parameter(name="obj", affordance="sittable"),),
        meaning="Sit down on obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "SITTABLE", "sit on")
        agent.demand_close(node)
        if "SITTING" in agent.node.states:
            agent.demand_standing()
        if len(agent.graph.sources(node, "ON")) >= SEATS.get(node.name, 1):
            refuse(f"there is no room left on the {node}")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.node.states.discard("LYING")
        agent.node.states.add("SITTING")
        agent.graph.add(agent.node, "ON", node)
        for seen in agent.graph.targets(node, "FACING"):
            agent.graph.add(agent.node, "FACING", seen)
