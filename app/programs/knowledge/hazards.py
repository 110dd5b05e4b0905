"""Requests that can hurt somebody, as rules over what is put where.

``static/knowledge/hazards.json``: each rule names things and places (``@class`` for all of a class),
what is harmless all the same, and the reason a person is told.
"""

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from app.programs.knowledge.classes import (
    FIGURES,
    PLAIN_ADJECTIVES,
    ThingClass,
    classes,
    normal,
)
from app.programs.knowledge.membership import TOYLIKE, belonging, endings, head_first

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "hazards.json"
SURE = 0.8


@dataclass(frozen=True, slots=True)
class Hazard:
    """One rule: none of these things goes to one of these places."""

    name: str
    things: frozenset[str]
    thing_classes: tuple[ThingClass, ...]
    places: frozenset[str]
    place_classes: tuple[ThingClass, ...]
    harmless_things: frozenset[str]
    harmless_places: frozenset[str]
    harmless_classes: tuple[ThingClass, ...]
    reason: str

    @property
    def of_toys(self) -> bool:
        """Whether it speaks of toys as well."""
        return any(each.name == "toy" for each in self.thing_classes)

    def meets(self, thing: str, place: str) -> bool:
        """Whether putting the thing to the place is what the rule speaks of."""
        return (
            _among(thing, self.things, self.thing_classes)
            and _among(place, self.places, self.place_classes)
            and not _named(thing, self.harmless_things)
            and not _named(place, self.harmless_places)
            and not any(belonging(place, each) >= SURE for each in self.harmless_classes)
        )


def hazard(thing: str, place: str) -> Hazard | None:
    """The first rule against putting the thing in, on or towards the place."""
    toy = _likeness(thing)
    # A toy knife cuts nobody, but it melts as any toy does, if not in a toy oven.
    rules = [r for r in hazards() if not toy or (r.of_toys and not _likeness(place))]
    return next((rule for rule in rules if rule.meets(thing, place)), None)


@cache
def hazards() -> tuple[Hazard, ...]:
    """The rules shipped with the service."""
    return tuple(map(_read, json.loads(FILE.read_text(encoding="utf-8"))))


def _read(entry: dict[str, str]) -> Hazard:
    things, thing_classes = _terms(entry["things"])
    places, place_classes = _terms(entry["places"])
    spared, _ = _terms(entry.get("never_things", ""))
    safe, safe_classes = _terms(entry.get("never_places", ""))
    return Hazard(
        entry["name"],
        things,
        thing_classes,
        places,
        place_classes,
        spared,
        safe,
        safe_classes,
        entry["reason"],
    )


def _terms(text: str) -> tuple[frozenset[str], tuple[ThingClass, ...]]:
    terms = [each.strip() for each in text.split(",") if each.strip()]
    known = classes().names()
    kinds = [each[1:] for each in terms if each.startswith("@") and each[1:] in known]
    nouns = frozenset(normal(each) for each in terms if not each.startswith("@"))
    return nouns, tuple(classes().named(kind) for kind in kinds)


def _among(name: str, nouns: frozenset[str], kinds: tuple[ThingClass, ...]) -> bool:
    return _named(name, nouns) or any(belonging(name, kind) >= SURE for kind in kinds)


def _named(name: str, nouns: frozenset[str]) -> bool:
    """Whether the whole name or its head is listed; a known compound is not its head."""
    if normal(name) in nouns:
        return True
    for place, ending in enumerate(endings(head_first(name))):
        if ending in nouns:
            return True
        plain = ending.split()[0] in PLAIN_ADJECTIVES  # An old laptop is one.
        if place == 0 and " " in ending and not plain and classes().knows(ending):
            return False
    return False


def _likeness(name: str) -> bool:
    """Whether it is a toy or a picture of the thing."""
    core = head_first(name)
    return bool(TOYLIKE & set(core[:-1])) or (len(core) > 1 and core[-1] in FIGURES)
