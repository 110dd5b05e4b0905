from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("type")
class Type(Unchanging):
    """Type on a keyboard or press keys of something switched."""

    signature = ActionSignature(
        name="type",
        parameters=(Parameter(name="obj"),),
        meaning="Type on obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if node.name != "keyboard":
            agent.demand_property(node, "HAS_SWITCH", "type on")
        agent.demand_close(node)
