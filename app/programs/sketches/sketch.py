"""Sketch: a sentence in the plan language's own form, before anything of it is looked up in a scene.

    grab_and_putin(all('fruits', but='banana'), one('plate', where='largest'))

A sketch keeps the sentence's words for things; the resolver finds out which objects they mean.
"""

from dataclasses import dataclass
from typing import Literal

from app.domain.program import literal

RELATIONS = ("left_of", "right_of", "near", "inside", "on", "behind", "in_front_of")
"""Keywords that place a thing by another one."""

Property = str
"""``colour``, ``material``, ``size``, ``shape`` or ``category``; others are taken and looked up."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Phrase:
    """Words for one object (``'red block'``, ``one(…)``) or for a set of them (``all(…)``)."""

    text: str
    quantity: Literal["one", "all"] = "one"
    but: tuple[str, ...] = ()
    """Words for what is left out of a set."""
    count: int | None = None
    """How many of a set; None for every one."""
    where: str | None = None
    """A superlative: ``leftmost``, ``largest`` …"""
    order: str | None = None
    """In which order a set is taken: ``largest first`` …"""
    relations: tuple[tuple[str, str], ...] = ()
    """Pairs of a keyword of ``RELATIONS`` and the words for the other thing."""

    def __str__(self) -> str:
        given: list[str] = [literal(self.text)]
        if self.but:
            shown = ", ".join(map(literal, self.but))
            given.append(f"but={shown}" if len(self.but) == 1 else f"but=[{shown}]")
        if self.count is not None:
            given.append(f"count={self.count}")
        given += [
            f"{key}={literal(value)}"
            for key, value in (("where", self.where), ("order", self.order), *self.relations)
            if value is not None
        ]
        plain = self.quantity == "one" and len(given) == 1
        return given[0] if plain else f"{self.quantity}({', '.join(given)})"


@dataclass(frozen=True, slots=True)
class Rest:
    """Everything movable that the sketch names nowhere else."""

    def __str__(self) -> str:
        return "rest"


@dataclass(frozen=True, slots=True)
class Previous:
    """As a target: each member goes onto the member before it."""

    def __str__(self) -> str:
        return "previous"


@dataclass(frozen=True, slots=True)
class Same:
    """As a target: the one of these that shares the property with the member."""

    property: Property
    text: str

    def __str__(self) -> str:
        return f"same({literal(self.property)}, {literal(self.text)})"


@dataclass(frozen=True, slots=True)
class Each:
    """As a target: every one of these gets ``count`` members."""

    text: str
    count: int = 1

    def __str__(self) -> str:
        counted = f", count={self.count}" if self.count != 1 else ""
        return f"each({literal(self.text)}{counted})"


SketchArgument = Phrase | Rest | Previous | Same | Each | float


@dataclass(frozen=True, slots=True)
class SketchCall:
    """A verb of the import line, applied to words."""

    action: str
    arguments: tuple[SketchArgument, ...]

    def __str__(self) -> str:
        shown = (repr(each) if isinstance(each, float) else str(each) for each in self.arguments)
        return f"{self.action}({', '.join(shown)})"


@dataclass(frozen=True, slots=True)
class Decline:
    """The verbs cannot do what is asked."""

    reason: str

    def __str__(self) -> str:
        return f"decline({literal(self.reason)})"


SketchStatement = SketchCall | Decline


@dataclass(frozen=True, slots=True)
class Sketch:
    """The statements in the order they were written."""

    body: tuple[SketchStatement, ...]
