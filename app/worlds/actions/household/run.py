from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("run")
class Run:
    """Go there in a hurry."""

    signature = ActionSignature(
        name="run",
        parameters=(Parameter(name="obj"),),
        meaning="Run to obj, an object or a room.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        agent.demand_standing()
        (node,) = nodes
        if agent.graph.room_of(node) is None:
            refuse(f"there is no way to the {node}")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        room = agent.graph.room_of(node)
        assert room is not None  # checked
        agent.walk_to(node, room)
