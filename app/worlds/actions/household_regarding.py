"""Regarding: what the verbs have in common that attend to a thing."""

from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Regarding(Unchanging):
    """Attend to what is faced."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_facing(node)
