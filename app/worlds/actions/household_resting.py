"""Resting: what sleeping and waking up have in common."""

from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


class Resting(Unchanging):
    """Where one sits or lies."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        del nodes
        if not agent.seated:
            refuse("the agent neither sits nor lies")
