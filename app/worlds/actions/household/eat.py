from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("eat")
class Eat(Unchanging):
    """Eat it, or what is on it."""

    signature = ActionSignature(
        name="eat",
        parameters=(Parameter(name="obj"),),
        meaning="Eat obj, or what is on it.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        served = (node, *agent.graph.sources(node, "ON"))
        if not any("EATABLE" in each.properties for each in served):
            refuse(f"nobody can eat the {node} or what is on it")
        agent.demand_close(node)
