"""Nudging: what pushing, pulling and moving have in common."""

from typing import ClassVar

from app.worlds.actions.household_unchanging import Unchanging
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Nudging(Unchanging):
    """Move it a little; it stays where it is as far as anybody can tell."""

    verb: ClassVar[str]

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        if node.name not in ("chair", "curtain"):
            agent.demand_property(node, "MOVABLE", self.verb)
        agent.demand_close(node)
        agent.demand_reachable(node)
        agent.demand_free_hand()
