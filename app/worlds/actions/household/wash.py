from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("wash")
class Wash:
    """Wash it by hand: it is clean then."""

    signature = ActionSignature(
        name="wash",
        parameters=(Parameter(name="obj"),),
        meaning="Wash obj by hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_close(node)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "DIRTY", "CLEAN")
