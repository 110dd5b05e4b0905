"""Releasing: what the verbs have in common that let go of a thing where one stands."""

from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Releasing:
    """Have it in no hand."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_held(node)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.let_go(node)
