from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("cut")
class Cut(Unchanging):
    """Cut food with a knife that is held."""

    signature = ActionSignature(
        name="cut",
        parameters=(Parameter(name="obj"),),
        meaning="Cut obj with a knife held in a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, "CUTTABLE", "cut")
        agent.demand_property(node, "EATABLE", "cut")
        agent.demand_close(node)
        if not any("knife" in each.name for each in agent.held):
            knives = [each for each in agent.graph.nodes.values() if "knife" in each.name]
            grabbable = [each for each in knives if "GRABBABLE" in each.properties]
            if grabbable:
                agent.demand_held(grabbable[0])
            refuse("there is no knife to cut with")
        agent.demand_free_hand()
