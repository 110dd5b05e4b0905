"""Symbolic: the perfect executor, a world of facts in which every admissible action succeeds."""

import json
from collections.abc import Iterable, Iterator, Mapping

from app.domain.action import SymbolicAction
from app.domain.condition import Relation
from app.domain.program import Argument
from app.domain.scene import Scene
from app.domain.trace import Frame
from app.domain.world import Stage

TELLING = ("in", "on", "held")
"""The relations that are worth telling; of what shuts, also whether it is open or closed."""


class SymbolicWorld:
    """Facts, and actions that change them as they say they do; nothing moves and no time passes."""

    def __init__(
        self, scene: Scene, facts: Iterable[Relation], actions: Mapping[str, SymbolicAction]
    ) -> None:
        """Begin.

        Args:
            scene: completed.
            facts: everything that is true, with what never changes: ``container(a)``, ``flat(a)``
                and the like.
            actions: by name.
        """
        self.scene = scene
        self.time = 0.0
        self._facts = frozenset(facts)
        self._actions = actions

    def perform(self, action: str, arguments: tuple[Argument, ...]) -> Iterator[Stage]:
        """Take over the action's effects.

        Raises:
            ActionFailure: a precondition is not met.
        """
        yield Stage(name="suppose")
        effects = self._actions[action].effects(self._facts, *map(str, arguments))
        self._facts = (self._facts - effects.removes) | effects.adds

    def holds(self, relation: Relation) -> bool:
        """Whether the relation is among the facts."""
        return relation in self._facts

    def facts(self) -> frozenset[Relation]:
        """The facts that are worth telling."""
        return frozenset(fact for fact in self._facts if self._is_telling(fact))

    def _is_telling(self, fact: Relation) -> bool:
        if fact.name in ("open", "closed"):
            return Relation("shuts", fact.arguments) in self._facts
        return fact.name in TELLING

    def settle(self) -> None:
        """Nothing moves."""

    def frames(self) -> tuple[Frame, ...]:
        """There are none."""
        return ()

    def save(self) -> bytes:
        """The facts as JSON."""
        return json.dumps(sorted([fact.name, *fact.arguments] for fact in self._facts)).encode()

    def restore(self, state: bytes) -> None:
        """Take up facts that ``save`` gave."""
        self._facts = frozenset(Relation(name, tuple(rest)) for name, *rest in json.loads(state))

    def begin(self) -> None:
        """No time has passed."""
