from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("turnto")
class TurnTo:
    """Turn to it; nothing else is faced then."""

    signature = ActionSignature(
        name="turnto",
        parameters=(Parameter(name="obj"),),
        meaning="Turn to obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del agent, nodes  # One can always turn.

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.detach(agent.node, ("FACING",), both_ways=False)
        agent.graph.add(agent.node, "FACING", node)
