from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("lookat")
class LookAt:
    """Look at what is faced."""

    signature = ActionSignature(
        name="lookat",
        parameters=(Parameter(name="obj"),),
        meaning="Look at obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_facing(node)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del agent, nodes  # Nothing changes.
