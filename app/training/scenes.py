"""Made-up scenes: a few things of a few classes, and what they can be put in or on."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from random import Random

from app.training.things import Vocabulary, choose

PLACES = ("left", "center", "right")
PROPERTIES = ("color", "material", "size", "position", "category")


@dataclass(frozen=True, slots=True)
class Item:
    """One object of a scene."""

    name: str
    noun: str
    kind: str = ""
    """The name of its class of things; empty for holders and look-alikes."""
    preposition: str = ""
    """``in`` or ``on`` for what holds other things."""
    properties: dict[str, str] = field(default_factory=dict, hash=False, compare=False)


@dataclass(frozen=True, slots=True)
class Setting:
    """A scene before anything is asked."""

    things: tuple[Item, ...]
    holders: tuple[Item, ...]
    order: tuple[Item, ...]
    shown: frozenset[str]
    """The properties that the prompt tells."""
    marked: str = ""
    """The property by which look-alikes differ; empty in scenes of classes."""

    def described(self) -> dict[str, dict[str, str]]:
        """Each object's told properties by name, in the scene's order."""
        return {
            item.name: {key: item.properties[key] for key in PROPERTIES if key in self.tells(item)}
            for item in self.order
        }

    def tells(self, item: Item) -> frozenset[str]:
        """The properties of this object that the prompt tells."""
        return self.shown & item.properties.keys()

    def listed(self, chosen: Iterable[Item]) -> list[Item]:
        """The chosen ones in the scene's order."""
        names = {item.name for item in chosen}
        return [item for item in self.order if item.name in names]


def class_scene(rng: Random, vocabulary: Vocabulary) -> Setting:
    """Things of one to three classes that nobody would mix up."""
    names = _disjoint_classes(rng, vocabulary, rng.choice((1, 2, 2, 3, 3, 3)))
    things: list[Item] = []
    for noun in _special(rng, vocabulary):
        things.append(Item(noun, noun, properties=_properties(rng, vocabulary)))
    for name in names:
        pool = vocabulary.classes[name].things
        for noun in rng.sample(pool, min(len(pool), rng.choice((1, 2, 2, 3, 3, 4, 4)))):
            if all(noun != other.noun for other in things):
                item = Item(noun, noun, name, properties=_properties(rng, vocabulary))
                item.properties["category"] = vocabulary.classes[name].one
                things.append(item)
    shown = _shown(rng, (("", 60), ("category", 12), ("color", 8), ("position", 14), ("size", 6)))
    return _setting(rng, vocabulary, things, shown)


def look_alike_scene(rng: Random, vocabulary: Vocabulary) -> Setting:
    """Several things of the same name that differ in one property, and a few others."""
    marked = rng.choice(
        ("color", "color", "color", "material", "material", "size", "position", "position")
    )
    in_name = rng.random() < 0.5 and marked != "position"
    things: list[Item] = []
    values = _values(marked, vocabulary)
    for _ in range(rng.choice((1, 1, 2))):
        noun = choose(rng, vocabulary.words["variants"], vocabulary.split)
        count = rng.randint(2, min(4, len(values)))
        if all(noun != other.noun for other in things):
            few = rng.sample(values, len(values))[:3]
            picked = [rng.choice(few) for _ in range(count)] if not in_name else few[:count]
            things += _look_alikes(rng, vocabulary, noun, marked, picked, in_name)
    for name in _disjoint_classes(rng, vocabulary, rng.choice((0, 1, 1, 2))):
        noun = rng.choice(vocabulary.classes[name].things)
        things.append(Item(noun, noun, name, properties=_properties(rng, vocabulary)))
    if in_name and rng.random() < 0.7:
        values = _values(marked, vocabulary)
        things = [
            each if each.noun != each.name else _named(each, marked, rng.choice(values))
            for each in things
        ]
        shown = frozenset({marked}) if rng.random() < 0.3 else frozenset()
    else:
        shown = frozenset({marked, *_shown(rng, (("", 70), ("color", 15), ("size", 15)))})
    marks = sorted({item.properties["color"] for item in things}) if marked == "color" else []
    return replace(_setting(rng, vocabulary, things, shown, marks), marked=marked)


def _look_alikes(
    rng: Random,
    vocabulary: Vocabulary,
    noun: str,
    marked: str,
    values: Sequence[str],
    in_name: bool,
) -> list[Item]:
    made: list[Item] = []
    for number, value in enumerate(values, start=1):
        properties = {**_properties(rng, vocabulary), marked: value}
        name = f"{value} {noun}" if in_name else f"{noun} {number}"
        made.append(Item(name, noun, properties=properties))
    return made


def _named(item: Item, marked: str, value: str) -> Item:
    properties = {**item.properties, marked: value}
    return replace(item, name=f"{value} {item.noun}", properties=properties)


def _values(marked: str, vocabulary: Vocabulary) -> list[str]:
    lists = {"color": "colours", "material": "materials", "size": "sizes"}
    return list(PLACES) if marked == "position" else list(vocabulary.words[lists[marked]])


def _properties(rng: Random, vocabulary: Vocabulary) -> dict[str, str]:
    words = vocabulary.words
    return {
        "color": rng.choice(words["colours"][:8]),
        "material": rng.choice(words["materials"][:6]),
        "size": rng.choice(words["sizes"]),
        "position": rng.choice(PLACES),
    }


def _shown(rng: Random, weighted: Sequence[tuple[str, int]]) -> frozenset[str]:
    names, weights = zip(*weighted, strict=True)
    return frozenset(rng.choices(names, weights)) - {""}


def _disjoint_classes(rng: Random, vocabulary: Vocabulary, count: int) -> list[str]:
    names = list(vocabulary.classes)
    chosen: list[str] = []
    for name in rng.sample(names, len(names)):
        if len(chosen) == count:
            break
        near = any(frozenset((name, other)) in vocabulary.close for other in chosen)
        if all(vocabulary.disjoint(name, other) for other in chosen) and (
            near or not chosen or rng.random() < 0.25
        ):
            chosen.append(name)
    return chosen


def _setting(
    rng: Random,
    vocabulary: Vocabulary,
    things: list[Item],
    shown: frozenset[str],
    marks: Sequence[str] = (),
) -> Setting:
    things = things[: rng.randint(5, 9)]
    holders = _holders(rng, vocabulary, {item.noun for item in things}, marks)
    order = [*things, *holders]
    if rng.random() < 0.7:
        rng.shuffle(order)
    return Setting(tuple(things), tuple(holders), tuple(order), shown)


def _special(rng: Random, vocabulary: Vocabulary) -> list[str]:
    """Now and then a thing that can be told by its use or by another word."""
    if rng.random() < 0.12:
        return [rng.choice(rng.choice(list(vocabulary.words["uses"].values())))]
    if rng.random() < 0.12:
        return [rng.choice(rng.choice(vocabulary.words["synonyms"]))]
    return []


def _holders(
    rng: Random, vocabulary: Vocabulary, taken: set[str], marks_wanted: Sequence[str] = ()
) -> list[Item]:
    count, words = rng.choice((1, 1, 1, 2, 2, 2, 3)), vocabulary.words
    made: list[Item] = []
    if count > 1 and rng.random() < 0.4:  # the same holder several times: left bin, right bin
        preposition = rng.choice(("in", "in", "on"))
        noun = choose(rng, words["containers"][preposition], vocabulary.split)
        marks = rng.choice((["left", "right"], ["top", "bottom", "middle"], words["colours"][:5]))
        if len(marks_wanted) > 1 and rng.random() < 0.6:
            marks = marks_wanted
        picked = rng.sample(list(marks), min(count, len(marks)))
        if noun not in taken:
            made = [Item(f"{mark} {noun}", noun, "", preposition, {}) for mark in picked]
    while len(made) < count:
        preposition = rng.choice(("in", "in", "in", "on", "on"))
        noun = choose(rng, words["containers"][preposition], vocabulary.split)
        mark = rng.choice(words["container_marks"][4:]) if rng.random() < 0.2 else ""
        if noun not in taken and all(noun != other.noun for other in made):
            made.append(Item(f"{mark} {noun}".strip(), noun, "", preposition, {}))
    return made
