from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("drink")
class Drink(Unchanging):
    """Drink it, or from it."""

    signature = ActionSignature(
        name="drink",
        parameters=(Parameter(name="obj"),),
        meaning="Drink obj, held in a hand, or what is in it.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if not node.properties & {"DRINKABLE", "RECIPIENT"}:
            refuse(f"nobody can drink the {node} or from it")
        agent.demand_held(node)
