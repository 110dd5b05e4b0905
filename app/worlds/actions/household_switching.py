"""Switching: what the verbs have in common that bring a device from one state to another."""

from typing import ClassVar

from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Switching:
    """By hand, from ``before`` to ``after``."""

    needed: ClassVar[str]
    """The property of what this can be done with."""
    verb: ClassVar[str]
    before: ClassVar[str]
    after: ClassVar[str]
    needs_hand: ClassVar[bool] = False
    """Whether a hand has to be free."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, self.needed, self.verb)
        agent.demand_close(node)
        if self.needs_hand:
            agent.demand_free_hand()
        agent.demand_state(node, self.before, verb="")

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.graph.change(node, self.before, self.after)
