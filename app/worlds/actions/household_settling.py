"""Settling: what sitting and lying down have in common."""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from app.domain.errors import ActionFailure
from app.domain.program import ActionCall
from app.worlds.simulators.household_agent import POSTURES, HouseholdAgent
from app.worlds.simulators.household_graph import Node


class Settling:
    """Take a posture on something that is made for it and has room left."""

    posture: ClassVar[str]
    needed: ClassVar[str]
    """The property of what one can settle on."""
    verb: ClassVar[str]
    room: ClassVar[Mapping[str, int]]
    """How much may be on it; one where it is not listed."""

    def check(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.demand_property(node, self.needed, self.verb)
        agent.demand_close(node)
        if self.posture in agent.node.states:
            agent.demand_standing()
        taken = agent.graph.sources(node, "ON")
        if len(taken) >= self.room.get(node.name, 1):
            reason = f"there is no room left on the {node}"
            raise ActionFailure("check", reason, remedy=self.cleared(taken))

    def cleared(self, taken: Sequence[Node]) -> tuple[ActionCall, ...]:
        """The calls that make room, if any are known."""
        del taken  # Unused.
        return ()

    def apply(self, agent: HouseholdAgent, *nodes: Node) -> None:
        (node,) = nodes
        agent.node.states.difference_update(POSTURES)
        agent.node.states.add(self.posture)
        agent.graph.add(agent.node, "ON", node)
