from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("putback")
class PutBack:
    """Let go of it on something."""

    signature = ActionSignature(
        name="putback",
        parameters=(
            Parameter(name="obj1", affordance="grabbable"),
            Parameter(name="obj2", role="support"),
        ),
        meaning="Put obj1, held in a hand, onto obj2.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        item, target = nodes
        if target in agent.graph.contents(item):
            refuse(f"the {target} is in or on the {item} itself")
        agent.demand_held(item)
        agent.demand_close(target)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        item, target = nodes
        agent.put(item, "ON", target)
