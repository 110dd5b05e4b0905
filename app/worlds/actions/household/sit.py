from collections.abc import Sequence

from app.domain.action import ActionSignature, Parameter
from app.domain.program import ActionCall
from app.worlds.actions.household import actions
from app.worlds.actions.household_settling import Settling
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node

SEATS = {"couch": 4, "sofa": 4, "bed": 4, "bench": 2, "loveseat": 2, "pianobench": 2}
"""How much may be on it; one where it is not listed."""


@actions.register("sit")
class Sit(Settling):
    """Sit down on it, if there is room."""

    signature = ActionSignature(
        name="sit",
        parameters=(Parameter(name="obj", affordance="sittable"),),
        meaning="Sit down on obj.",
    )
    posture, needed, verb = "SITTING", "SITTABLE", "sit on"
    room = SEATS

    def cleared(self, taken: Sequence[Node]) -> tuple[ActionCall, ...]:
        loose = next((each for each in taken if "GRABBABLE" in each.properties), None)
        return (ActionCall(action="grab", arguments=(loose.name,)),) if loose else ()

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        super().apply(agent, *nodes)
        (node,) = nodes
        for seen in agent.graph.targets(node, "FACING"):
            agent.graph.add(agent.node, "FACING", seen)
