from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("pour")
class Pour:
    """Pour what is held into a vessel."""

    signature = ActionSignature(
        name="pour",
        parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
        meaning="Pour obj1, held in a hand, into obj2.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        item, target = nodes
        if not item.properties & {"POURABLE", "DRINKABLE"}:
            refuse(f"nobody can pour the {item}")
        agent.demand_property(target, "RECIPIENT", "pour anything into")
        agent.demand_held(item)
        agent.demand_close(target)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        item, target = nodes
        agent.graph.add(item, "INSIDE", target)
