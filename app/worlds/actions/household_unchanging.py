"""Unchanging: what the verbs have in common after which the home is as it was."""

from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Unchanging:
    """Done without a trace that the graph could keep."""

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del agent, nodes  # Nothing changes.
