from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("pull")
class Pull:
    """Pull it a little; it stays where it is as far as anybody can tell."""

    signature = ActionSignature(
        name="pull",
        parameters=(Parameter(name="obj", affordance="movable"),),
        meaning="Pull obj.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if node.name not in ("chair", "curtain"):
            agent.demand_property(node, "MOVABLE", "pull")
        agent.demand_close(node)
        agent.demand_reachable(node)
        agent.demand_free_hand()

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del agent, nodes  # Nothing changes.
