"""Putting: what the verbs have in common that let go of a held thing in or on another."""

from typing import ClassVar

from app.worlds.simulators.household_agent import HouseholdAgent, refuse
from app.worlds.simulators.household_graph import Node


class Putting:
    """From a hand to where the ``relation`` says, which has to be open if it is to be inside."""

    relation: ClassVar[str]

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        item, target = nodes
        if target in agent.graph.contents(item):
            refuse(f"the {target} is in or on the {item} itself")
        agent.demand_held(item)
        agent.demand_close(target)
        if self.relation == "INSIDE" and agent.afforded("INSIDE", target) == "INSIDE":
            agent.demand_open(target)

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        item, target = nodes
        agent.put(item, self.relation, target)
