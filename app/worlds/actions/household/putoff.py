from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("putoff")
class PutOff:
    """Take off clothes that are worn."""

    signature = ActionSignature(
        name="putoff",
        parameters=(Parameter(name="obj"),),
        meaning="Take off obj, clothes worn.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "CLOTHES", "take off")
        if not agent.graph.has(node, "ON", agent.node):
            refuse(f"the agent does not wear the {node}")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.remove(node, "ON", agent.node)
