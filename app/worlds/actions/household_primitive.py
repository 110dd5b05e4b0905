"""HouseholdAction: what every verb of the household's agent is."""

from typing import Protocol

from app.domain.action import ActionSignature
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class HouseholdAction(Protocol):
    """A verb over nodes of the graph; to check it changes nothing."""

    signature: ActionSignature

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        """Whether the agent can do it as things stand.

        Raises:
            ActionFailure: a precondition is not met; its remedy brings it about, if anything does.
        """
        ...

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        """Do what was checked."""
        ...
