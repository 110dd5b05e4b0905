from app.domain.action import ActionSignature
from app.domain.errors import ActionFailure
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


@actions.register("standup")
class StandUp:
    """Get up from where one sits or lies."""

    signature = ActionSignature(
        name="standup",
        parameters=(),
        meaning="Stand up.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del nodes
        if not agent.seated:
            raise ActionFailure("check", "the agent stands already", needless=True)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del nodes
        agent.node.states.difference_update(("SITTING", "LYING"))
        if not agent.official:
            agent.graph.detach(agent.node, ("ON",), both_ways=False)
