"""What sentences are made of, read from ``static/training`` and from a user's own folder.

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
from typing import Any, Literal, TypeVar

Split = Literal["train", "held"]
T = TypeVar("T")

FOLDER = Path(__file__).parents[2] / "static" / "training"
HELD_CLASSES = frozenset(
    {"insects", "aircraft", "desserts", "eyewear", "garden tools", "medical supplies", "cheeses"}
)
HELD_EVERY = 12


@dataclass(frozen=True, slots=True)
class ThingClass:
    """A class of things: ``fruits``, one of which is a ``fruit``."""

    many: str
    one: str
    members: tuple[str, ...]


def is_held(text: str) -> bool:
    """Whether this entry belongs to the held-out part; the same on every machine."""
    return zlib.crc32(text.encode()) % HELD_EVERY == 0


class Words:
    """The words of one split, and the choices made among them."""

    def __init__(self, rng: Random, split: Split, data: Path | None = None) -> None:
        self.rng = rng
        self.split: Split = split
        self.lists = load_lists(data)

    def choose(self, options: Sequence[T]) -> T:
        """In training never a held-out entry; else a held-out one where there is one."""
        part = [each for each in options if is_held(str(each)) == (self.split == "held")]
        return self.rng.choice(part or list(options))

    def say(self, *path: str) -> Any:  # noqa: ANN401 (whatever the file holds)
        """One entry of the list at this place in the files: ``say("put", "do")``."""
        found: Any = self.lists
        for name in path:
            found = found[name]
        return self.choose(found)

    def chance(self, share: float) -> bool:
        """True that often."""
        return self.rng.random() < share

    def classes(self) -> list[ThingClass]:
        """Those of this split."""
        return _classes(self.lists["classes"], self.lists["wordnet"], self.split)


_LOADED: dict[Path | None, dict[str, Any]] = {}


def load_lists(data: Path | None = None) -> dict[str, Any]:
    """Every file's content by its name; the user's lists lengthen ours."""
    if data not in _LOADED:
        found: dict[str, Any] = {}
        for folder in (FOLDER, data):
            for path in sorted(folder.glob("*.json")) if folder else ():
                found[path.stem] = _joined(
                    found.get(path.stem), json.loads(path.read_text(encoding="utf-8"))
                )
        _LOADED[data] = found
    return _LOADED[data]


def _joined(ours: Any, more: Any) -> Any:  # noqa: ANN401 (JSON)
    """Lists one after the other, objects key by key."""
    if isinstance(ours, list) and isinstance(more, list):
        return ours + more
    if isinstance(ours, dict) and isinstance(more, dict):
        return {key: _joined(ours.get(key), more.get(key)) for key in {**ours, **more}}
    return ours if more is None else more


def _classes(table: dict, wordnet: dict, split: Split) -> list[ThingClass]:
    key = (id(table), split)
    if key not in _CLASSES:
        _CLASSES[key] = list(_read_classes(table, wordnet, split))
    return _CLASSES[key]


_CLASSES: dict[tuple[int, Split], list[ThingClass]] = {}


def _read_classes(table: dict, wordnet: dict, split: Split) -> list[ThingClass]:
    found: list[ThingClass] = []
    for name, entry in table.items():
        if (name in HELD_CLASSES) != (split == "held"):
            continue
        members = tuple(dict.fromkeys(entry["things"] + wordnet.get(name, [])))
        found.append(ThingClass(name, entry["one"], members))
        found += [
            ThingClass(alias, one, members)
            for alias in entry.get("alias", ())
            if (one := singular(alias)) != alias
        ]
    return found


IRREGULAR = {
    "knife": "knives",
    "mouse": "mice",
    "goose": "geese",
    "loaf": "loaves",
    "leaf": "leaves",
    "shelf": "shelves",
    "scarf": "scarves",
    "tooth": "teeth",
    "foot": "feet",
    "child": "children",
    "tomato": "tomatoes",
    "potato": "potatoes",
    "mango": "mangoes",
    "fish": "fish",
    "sheep": "sheep",
    "aircraft": "aircraft",
}
_BACK = {many: one for one, many in IRREGULAR.items()}


def plural(noun: str) -> str:
    """More than one of it."""
    head, _, last = noun.rpartition(" ")
    if last in IRREGULAR:
        many = IRREGULAR[last]
    elif last.endswith(("x", "ch", "sh", "ss", "us")):
        many = f"{last}es"
    elif last.endswith("s"):
        many = last
    elif last.endswith("y") and len(last) > 2 and last[-2] not in "aeiou":
        many = f"{last[:-1]}ies"
    else:
        many = f"{last}s"
    return f"{head} {many}".strip()


def singular(noun: str) -> str:
    """One of them, as far as a rule goes."""
    head, _, last = noun.rpartition(" ")
    if last in _BACK:
        one = _BACK[last]
    elif last.endswith("ies") and len(last) > 4:
        one = f"{last[:-3]}y"
    elif last.endswith(("ches", "shes", "sses", "xes")):
        one = last[:-2]
    elif last.endswith("s") and not last.endswith("ss"):
        one = last[:-1]
    else:
        one = last
    return f"{head} {one}".strip()


@cache
def article(noun: str) -> str:
    """``a`` or ``an``."""
    return "an" if noun[:1] in "aeiou" and not noun.startswith(("uni", "use", "eu", "one")) else "a"
