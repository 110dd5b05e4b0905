from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("puton")
class PutOn:
    """Put on clothes that are held."""

    signature = ActionSignature(
        name="puton",
        parameters=(Parameter(name="obj"),),
        meaning="Put on obj, clothes held in a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "CLOTHES", "wear")
        agent.demand_held(node)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.let_go(node)
        agent.graph.add(node, "ON", agent.node)
