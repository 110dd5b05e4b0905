from app.domain.action import ActionSignature
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


@actions.register("wakeup")
class WakeUp:
    """Wake up where one sits or lies."""

    signature = ActionSignature(
        name="wakeup",
        parameters=(),
        meaning="Wake up.",
    )

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del nodes
        if not agent.seated:
            refuse("the agent neither sits nor lies")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del agent, nodes  # Nothing changes.
