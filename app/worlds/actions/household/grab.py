from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("grab")
class Grab:
    """Take it with the free hand, the right one first."""

    signature = ActionSignature(
        name="grab",
        parameters=(Parameter(name="obj", affordance="grabbable"),),
        meaning="Take obj into a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "GRABBABLE", "take")
        if agent.holds(node):
            return
        agent.demand_close(node)
        agent.demand_reachable(node)
        agent.demand_free_hand()

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        hand = agent.free_hand()
        if hand is not None and not agent.holds(node):
            agent.take(node, hand)
