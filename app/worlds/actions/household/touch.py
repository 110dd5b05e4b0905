from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("touch")
class Touch(Unchanging):
    """Touch what is within reach."""

    signature = ActionSignature(
        name="touch",
        parameters=(Parameter(name="obj"),),
        meaning="Touch obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_close(node)
        agent.demand_reachable(node)
