from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("release")
class Release:
    """Let go of it where one stands."""

    signature = ActionSignature(
        name="release",
        parameters=(Parameter(name="obj"),),
        meaning="Let go of obj, held in a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_held(node)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.let_go(node)
