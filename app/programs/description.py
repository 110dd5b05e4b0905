"""A scene as the dict of a prompt: what each object is, what it is for, and how and where it stands."""

from collections.abc import Collection, Iterator, Sequence

from app.domain.condition import Relation
from app.domain.program import Described, PropertyValue
from app.domain.scene import Scene, SceneObject
from app.programs.properties import properties_of

PLACES = ("in", "on")
"""Facts of two objects that say where the first one is."""
STATE = "state"
"""The property that holds the facts of an object alone: ``['closed', 'switched_off']``."""


def describe_scene(scene: Scene, facts: Collection[Relation]) -> tuple[Described, ...]:
    """Every object with its properties, its affordances, its states and its place, in order.

    The facts are those that are true where the plan begins; their order does not count.
    """
    in_order = sorted(facts, key=lambda fact: (fact.name, fact.arguments))
    return tuple(
        Described(name=item.name, properties=tuple(_told(item, in_order))) for item in scene.objects
    )


def _told(item: SceneObject, facts: Sequence[Relation]) -> Iterator[tuple[str, PropertyValue]]:
    for name, value in properties_of(item):
        words = value.replace("_", " ") if isinstance(value, str) else value
        if name != "kind" and value is not False and words != item.name:
            yield name, value
    about = [fact for fact in facts if fact.arguments[:1] == (item.name,)]
    states = tuple(fact.name for fact in about if len(fact.arguments) == 1)
    if states:
        yield STATE, states
    for name in PLACES:
        places = [
            fact.arguments[1] for fact in about if fact.name == name and len(fact.arguments) == 2
        ]
        if places:
            yield name, places[0] if len(places) == 1 else tuple(places)
