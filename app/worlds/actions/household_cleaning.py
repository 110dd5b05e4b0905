"""Cleaning: what the verbs have in common after which a thing is clean."""

from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Cleaning:
    """By hand, what one is close to."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_close(node)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, "DIRTY", "CLEAN")
