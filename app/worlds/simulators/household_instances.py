"""Which of several things of one name is meant: the one at hand."""

import random
from collections.abc import Callable
from itertools import product

from app.domain.errors import ActionFailure
from app.domain.program import ActionCall
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import Node

TRIES = 64
"""So many choices are checked before the likeliest one's failure is told."""

Check = Callable[..., None]


class Instances:
    """Chooses nodes for class names, and remembers what was chosen."""

    def __init__(self, agent: HouseholdAgent, rng: random.Random | None = None) -> None:
        """With ``rng`` as in the paper's release: walk and find draw, and what they found stays."""
        self._agent = agent
        self._rng = rng
        self.used: dict[str, int] = {}
        """The id of what was used last, by class name."""
        self.shunned: set[int] = set()
        """Ids of what turned out to be the wrong one: there, another is meant."""

    def choose(self, action: str, check: Check, names: tuple[str, ...]) -> tuple[Node, ...]:
        """The nodes that are meant: of those with which the action can be done the likeliest.

        Raises:
            ActionFailure: there is nothing of a name, or it can be done with none; then the
                failure of the likeliest choice.
        """
        ranked = [self._ranked(action, name, place) for place, name in enumerate(names)]
        if self._rng is not None:
            chosen = tuple(each[0] for each in ranked)
            check(self._agent, *chosen)
            return self._remember(chosen)
        first: ActionFailure | None = None
        for tried, chosen in enumerate(product(*ranked)):
            try:
                check(self._agent, *chosen)
            except ActionFailure as failure:
                first = first or failure
                if tried >= TRIES:
                    break
            else:
                return self._remember(chosen)
        assert first is not None
        raise self._turn_from(ranked[0], first) if ranked else first

    def _turn_from(self, ranked: list[Node], failure: ActionFailure) -> ActionFailure:
        """If nothing would help with the likeliest, then to find another of its name might."""
        self.shunned.add(ranked[0].id)
        if failure.remedy or all(node.id in self.shunned for node in ranked):
            self.shunned.difference_update(node.id for node in ranked)
            return failure
        another = ActionCall(action="find", arguments=(ranked[0].name,))
        return ActionFailure(
            failure.stage, failure.reason, remedy=(another,), needless=failure.needless
        )

    def _remember(self, chosen: tuple[Node, ...]) -> tuple[Node, ...]:
        for node in chosen:
            self.used[node.name] = node.id
        return chosen

    def _ranked(self, action: str, name: str, place: int) -> list[Node]:
        nodes = self._agent.graph.named(name)
        if not nodes:
            raise ActionFailure("check", f"there is no {name} in this home")
        if len(nodes) == 1:
            return list(nodes)
        if self._rng is not None:
            return [self._drawn(action, nodes, place)]
        here = self._agent.room()
        another = action == "grab"
        return sorted(nodes, key=lambda node: self._distance(node, here, another))

    def _distance(self, node: Node, here: Node | None, another: bool) -> tuple[object, ...]:
        """What is nearer, or was used already, is likelier; who takes one more takes another."""
        agent = self._agent
        return (
            node.id in self.shunned,
            agent.holds(node) is another,
            self.used.get(node.name) != node.id,
            agent.shut_in(node) is not None,
            not agent.is_close(node),
            agent.graph.room_of(node) is not here,
            node.id,
        )

    def _drawn(self, action: str, nodes: tuple[Node, ...], place: int) -> Node:
        """As the release does: found by chance, then the same again where it fits."""
        assert self._rng is not None
        held = [node for node in nodes if self._agent.holds(node)]
        if action.startswith("put") and place == 0 and held:
            return held[0]
        found = self.used.get("")
        if action not in ("find", "walk"):
            same = next((node for node in nodes if node.id == found), None)
            return same or self._rng.choice(nodes)
        drawn = self._rng.choice(nodes)
        self.used[""] = drawn.id
        return drawn
