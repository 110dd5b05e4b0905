from app.domain.action import ActionSignature, Parameter
from app.domain.errors import ActionFailure
from app.domain.program import ActionCall
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
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
        taken = agent.graph.sources(node, "ON")
        if len(taken) >= SEATS.get(node.name, 1):
            loose = next((each for each in taken if "GRABBABLE" in each.properties), None)
            remedy = (ActionCall(action="grab", arguments=(loose.name,)),) if loose else ()
            raise ActionFailure("check", f"there is no room left on the {node}", remedy=remedy)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.node.states.discard("LYING")
        agent.node.states.add("SITTING")
        agent.graph.add(agent.node, "ON", node)
        for seen in agent.graph.targets(node, "FACING"):
            agent.graph.add(agent.node, "FACING", seen)
