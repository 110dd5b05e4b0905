"""What tasks are about: classes of things and the words around them, read from ``static/training``.

Every list is split in two by a checksum of its entries: some nouns, classes and ways of saying
things are held out of training, so that a figure can be had on what was never seen.
"""

import json
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from random import Random
from typing import Literal, TypeVar

Split = Literal["train", "held"]
T = TypeVar("T")

FOLDER = Path(__file__).parents[2] / "static" / "training"
HELD_CLASSES = frozenset(
    {"insects", "aircraft", "desserts", "eyewear", "garden tools", "medical supplies", "cheeses"}
)
HELD_NOUN_EVERY = 6
HELD_PHRASE_EVERY = 7


@dataclass(frozen=True, slots=True)
class ThingClass:
    """A class of things: ``fruits``, one of which is a ``fruit``."""

    name: str
    one: str
    aliases: tuple[str, ...]
    things: tuple[str, ...]


def is_held(text: str, every: int) -> bool:
    """Whether this entry belongs to the held-out part; the same on every machine."""
    return zlib.crc32(text.encode()) % every == 0


def choose(rng: Random, options: Sequence[T], split: Split) -> T:
    """A way of saying it: in training never a held-out one, else a held-out one where there is."""
    part = [each for each in options if is_held(str(each), HELD_PHRASE_EVERY) == (split == "held")]
    return rng.choice(part or list(options))


class Vocabulary:
    """The words of one split."""

    def __init__(self, split: Split) -> None:
        self.split: Split = split
        self.words = load_words()
        self.classes = {each.name: each for each in _classes(split)}
        self.overlaps = [frozenset(group) for group in self.words["overlaps"]]
        self.close = {frozenset(pair) for pair in self.words["close_pairs"]}

    def disjoint(self, first: str, second: str) -> bool:
        """Whether nobody would count things of one class among the other."""
        pair = frozenset((first, second))
        return pair in self.close or not any(pair <= group for group in self.overlaps)

    def supers(self, names: Sequence[str]) -> list[tuple[str, list[str]]]:
        """Wider classes by which the scene's classes can be told apart, with those they cover."""
        found: list[tuple[str, list[str]]] = []
        for name, parts in self.words["supers"].items():
            covered = [each for each in names if each in parts]
            others = [each for each in names if each not in parts]
            if covered and all(self.disjoint(a, b) for a in parts for b in others):
                found.append((name, covered))
        return found


@cache
def load_words() -> dict:
    """The lists of ``words.json``."""
    return json.loads((FOLDER / "words.json").read_text(encoding="utf-8"))


def _classes(split: Split) -> list[ThingClass]:
    table = json.loads((FOLDER / "classes.json").read_text(encoding="utf-8"))
    extra = json.loads((FOLDER / "wordnet.json").read_text(encoding="utf-8"))
    found: list[ThingClass] = []
    for name, entry in table.items():
        if split == "train" and name in HELD_CLASSES:
            continue
        things = dict.fromkeys(entry["things"] + extra.get(name, []))
        if split == "train" or name not in HELD_CLASSES:
            things = [
                each for each in things if is_held(each, HELD_NOUN_EVERY) == (split == "held")
            ]
        if len(things) >= 2:
            aliases = tuple(entry.get("alias", ()))
            found.append(ThingClass(name, entry["one"], aliases, tuple(things)))
    return found
