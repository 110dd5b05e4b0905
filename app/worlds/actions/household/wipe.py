from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("wipe")
class Wipe:
    """Wipe it with what is held: it is clean then."""

    signature = ActionSignature(
        name="wipe",
        parameters=(Parameter(name="obj"),),
        meaning="Wipe obj with what is held in a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_close(node)
        if not agent.held:
            refuse("there is nothing in the agent's hands to wipe with")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "DIRTY", "CLEAN")
