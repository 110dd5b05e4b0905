from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("read")
class Read(Unchanging):
    """Read what is held."""

    signature = ActionSignature(
        name="read",
        parameters=(Parameter(name="obj", affordance="readable"),),
        meaning="Read obj, held in a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "READABLE", "read")
        agent.demand_held(node)
