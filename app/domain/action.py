"""Action primitives: what a robot's verbs are called, and what they do to the facts."""

from dataclasses import dataclass
from typing import Literal, Protocol

from app.domain.condition import Relation


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter:
    """One parameter of an action primitive, named as the import line shows it."""

    name: str
    role: Literal["object", "container", "support", "number", "word"] = "object"
    """A ``container`` holds things where the scene has any that do; a ``support`` is any object."""
    words: tuple[str, ...] = ()
    """What a ``word`` may be: ``("left", "right")``."""
    affordance: str | None = None
    """What it has to afford, ``can_open``, in scenes whose objects tell of their affordances."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionSignature:
    """What a planner is told of an action primitive."""

    name: str
    parameters: tuple[Parameter, ...]
    meaning: str
    """One sentence, as the documentation shows it."""
    said: str = ""
    """What people say who want it done, as a regular expression; nothing where its name says it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Effects:
    """Which facts an action makes true and which it ends, if all goes well."""

    adds: frozenset[Relation] = frozenset()
    removes: frozenset[Relation] = frozenset()


class SymbolicAction(Protocol):
    """What an action does in the perfect executor, where nothing slips."""

    signature: ActionSignature

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """The change it makes where ``facts`` hold.

        Raises:
            ActionFailure: a precondition is not met; the reason names it.
        """
        ...
