"""Condition: a relation over objects, or a combination of such, true or false in a world."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import assert_never


@dataclass(frozen=True, slots=True)
class Relation:
    """A fact that may hold: ``Relation("in", ("banana", "bowl"))``, written ``in(banana, bowl)``."""

    name: str
    arguments: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.arguments)})"


@dataclass(frozen=True, slots=True)
class Not:
    """True where the other is false."""

    condition: "Condition"

    def __str__(self) -> str:
        return f"not {self.condition}"


@dataclass(frozen=True, slots=True)
class AnyOf:
    """True where at least one of them is."""

    conditions: tuple["Condition", ...]

    def __str__(self) -> str:
        return f"any_of({', '.join(map(str, self.conditions))})"


@dataclass(frozen=True, slots=True)
class Count:
    """True where exactly so many of the objects are in the container."""

    container: str
    objects: tuple[str, ...]
    number: int

    def __str__(self) -> str:
        return f"count({self.container}; {' | '.join(self.objects)}) = {self.number}"


@dataclass(frozen=True, slots=True)
class Property:
    """True where an object is so described: ``category('banana') == 'fruit'``.

    It never changes, so a program's properties are decided when it is grounded. The property
    ``name`` is what the object is called.
    """

    name: str
    subject: str
    value: str | float | bool

    def __str__(self) -> str:
        return f"{self.name}({self.subject}) = {self.value}"


Condition = Relation | Not | AnyOf | Count | Property


def all_of(*conditions: Condition) -> Condition:
    """True where all of them are: ``not any_of(not …, not …)``."""
    if len(conditions) == 1:
        return conditions[0]
    return Not(AnyOf(tuple(Not(condition) for condition in conditions)))


def conjuncts(condition: Condition) -> tuple[Condition, ...]:
    """What ``all_of`` was made from; the condition alone where it is no such thing."""
    match condition:
        case Not(AnyOf(conditions)) if len(conditions) > 1:
            inner = [each.condition for each in conditions if isinstance(each, Not)]
            return tuple(inner) if len(inner) == len(conditions) else (condition,)
        case _:
            return (condition,)


def decide(condition: Condition, holds: Callable[[Relation], bool]) -> bool:
    """Whether ``condition`` is true where ``holds`` tells which relations are."""
    match condition:
        case Relation():
            return holds(condition)
        case Not(inner):
            return not decide(inner, holds)
        case AnyOf(conditions):
            return any(decide(inner, holds) for inner in conditions)
        case Count(container, objects, number):
            inside = sum(holds(Relation("in", (item, container))) for item in objects)
            return inside == number
        case Property(name, subject, value):
            return holds(Relation(name, (subject, str(value))))
        case _:
            assert_never(condition)


def relations(condition: Condition) -> tuple[Relation, ...]:
    """Every relation the condition speaks of, in the order it is written."""
    match condition:
        case Relation():
            return (condition,)
        case Not(inner):
            return relations(inner)
        case AnyOf(conditions):
            return tuple(found for inner in conditions for found in relations(inner))
        case Count(container, objects, _):
            return tuple(Relation("in", (item, container)) for item in objects)
        case Property(name, subject, value):
            return (Relation(name, (subject, str(value))),)
        case _:
            assert_never(condition)
