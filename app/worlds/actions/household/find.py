from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("find")
class Find:
    """Be close to it: where it is near already, nobody walks."""

    signature = ActionSignature(
        name="find",
        parameters=(Parameter(name="obj"),),
        meaning="Look for obj and go to it, if it is not close already.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if not agent.is_close(node):
            agent.demand_standing()
            if agent.graph.room_of(node) is None:
                refuse(f"there is no way to the {node}")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        room = agent.graph.room_of(node)
        if agent.is_close(node) or room is None:
            agent.graph.detach(agent.node, ("FACING",), both_ways=False)
            agent.graph.bring_close(agent.node, node)
        else:
            agent.walk_to(node, room)
