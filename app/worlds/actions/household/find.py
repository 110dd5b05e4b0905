from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_walking import Walking
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("find")
class Find(Walking):
    """Be close to it: where it is near already, nobody walks."""

    signature = ActionSignature(
        name="find",
        parameters=(Parameter(name="obj"),),
        meaning="Look for obj and go to it, if it is not close already.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if not agent.is_close(node):
            super().check(agent, *nodes)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if agent.is_close(node):
            agent.graph.detach(agent.node, ("FACING",), both_ways=False)
            agent.graph.bring_close(agent.node, node)
        else:
            super().apply(agent, *nodes)
