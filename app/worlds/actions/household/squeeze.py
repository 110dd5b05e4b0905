from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node

SOFT = frozenset(
    ("towel", "sponge", "washingsponge", "paper", "toothpaste", "barsoap", "lemon", "lime", "rag")
)


@actions.register("squeeze")
class Squeeze(Unchanging):
    """Squeeze something soft with a free hand."""

    signature = ActionSignature(
        name="squeeze",
        parameters=(Parameter(name="obj"),),
        meaning="Squeeze obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if node.name not in SOFT:
            agent.demand_property(node, "CLOTHES", "squeeze")
        agent.demand_close(node)
        agent.demand_free_hand()
