from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_cleaning import Cleaning
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("wipe")
class Wipe(Cleaning):
    """Wipe it with what is held: it is clean then."""

    signature = ActionSignature(
        name="wipe",
        parameters=(Parameter(name="obj"),),
        meaning="Wipe obj with what is held in a hand.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        super().check(agent, *nodes)
        if not agent.held:
            refuse("there is nothing in the agent's hands to wipe with")
