"""Classes of things as people speak of them, and whether a thing belongs to one.

``static/knowledge/classes.json`` holds what WordNet has wrong or does not know: for each class its
other names, its nouns, what counts as one only as it stands (a ``file`` smooths, a ``card file``
does not), what counts as one only perhaps, what never does, where in WordNet more are
found, classes that are parts of it, and what its things are used for. In a class with ``contents``
a container of the thing counts too (a ``ketchup bottle`` is a condiment).
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from app.programs.knowledge.names import (
    DETERMINERS,
    PORTIONS,
    singular,
    stem,
    words,
)
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "classes.json"
VAGUE = word_list("vague")
_FILLER = word_list("filler")
UNREAL = word_list("unreal")
"""Said before a noun, the thing is a likeness of it."""
PLAIN_ADJECTIVES = word_list("plain_adjectives")
FIGURES = word_list("figures")
"""Said after a noun, the thing is a likeness of it."""
LIVELY = word_list("lively")
"""Classes whose likenesses count as members: a toy truck is a vehicle on a table."""
HOLDERS = word_list("holders")


_DRUNK = word_list("drunk")
"""Said before "glasses", they are to drink from."""


@dataclass(frozen=True, slots=True)
class ThingClass:
    """One class; all words as ``normal`` makes them."""

    name: str
    members: frozenset[str]
    alone: frozenset[str]
    """Members only as they stand, not as the end of a longer name."""
    perhaps: frozenset[str]
    never: frozenset[str]
    roots: frozenset[str]
    """WordNet's meanings."""
    contents: bool
    likenesses: bool


class Classes:
    """All classes, with the ways people name them."""

    def __init__(self, entries: dict[str, dict[str, object]]) -> None:
        self._entries = entries
        self._names: dict[str, str] = {}
        self._adjectives: dict[str, str] = {}
        self._uses: list[tuple[frozenset[str], str]] = []
        self._known: dict[str, set[str]] = {}
        self._made: dict[str, ThingClass] = {}
        for name in entries:
            self._names[normal(name)] = name
        for name, entry in entries.items():
            self._index(name, entry)

    def find(self, phrase: str) -> ThingClass | None:
        """The class that a phrase names or describes, if it is one of these."""
        whole = _undetermined(words(phrase))
        if len(whole) > 2 and whole[1] == "of" and singular(whole[0]) in VAGUE | PORTIONS:
            whole = whole[2:]
        if not whole:
            return None
        name = self._names.get(normal(" ".join(whole)))
        rest = tuple(each for each in whole if each not in VAGUE)
        if name is None and rest and len(rest) < len(whole):
            name = self._adjectives.get(normal(" ".join(rest)))
        if name is None:
            name = self._used_for(whole) or self._of_trade(whole)
        return self.named(name) if name else None

    def named(self, name: str) -> ThingClass:
        """The class of exactly this name."""
        if name not in self._made:
            entry = self._entries[name]
            members, perhaps = set(_listed(entry, "nouns")), set(_listed(entry, "perhaps"))
            roots = {s for each in _terms(entry, "wordnet") for s in nouns().root(each)}
            for part in _terms(entry, "parts"):
                inner = self.named(part)
                members |= inner.members
                roots |= inner.roots
            never = frozenset(_listed(entry, "never"))
            self._made[name] = ThingClass(
                name,
                frozenset(members - never),
                frozenset(_listed(entry, "alone")),
                frozenset(perhaps - members),
                never,
                frozenset(roots),
                bool(entry.get("contents", False)),
                name in LIVELY,
            )
        return self._made[name]

    def names(self) -> tuple[str, ...]:
        """The classes' own names."""
        return tuple(self._entries)

    def knows(self, noun: str) -> bool:
        """Whether any class lists it."""
        return noun in self._known

    def share(self, noun: str, other: str) -> bool:
        """Whether some class lists both."""
        return bool(self._known.get(noun, set()) & self._known.get(other, set()))

    def _index(self, name: str, entry: dict[str, object]) -> None:
        for alias in (name, *_terms(entry, "also")):
            spoken = _undetermined(words(alias))
            self._names.setdefault(normal(" ".join(spoken)), name)
            rest = [each for each in spoken if each not in VAGUE]
            if rest and len(rest) < len(spoken):
                self._adjectives.setdefault(normal(" ".join(rest)), name)
            used = _stems(spoken)
            if len(rest) < len(spoken) and len(used) < len(spoken) - 1:
                self._uses.append((used, name))
        for use in _terms(entry, "uses"):
            self._uses.append((_stems(words(use)), name))
        for key in ("nouns", "alone", "perhaps"):
            for noun in _listed(entry, key):
                self._known.setdefault(noun, set()).add(name)

    def _of_trade(self, whole: tuple[str, ...]) -> str | None:
        """The class of who does something with it: "what the postman brought" is the postman's."""
        said = [each for each in whole if each not in DETERMINERS or each in VAGUE]
        if len(said) != 3 or not (said[0] in VAGUE or said[0] == "what"):
            return None
        return self._names.get(normal(f"{said[1]}'s things"))

    def _used_for(self, whole: tuple[str, ...]) -> str | None:
        """The class whose use is told in the phrase, the longest one that fits."""
        if not any(each in VAGUE or each in ("what", "tool", "device") for each in whole):
            return None
        said = _stems(whole)
        fitting = [(len(used), name) for used, name in self._uses if used and used <= said]
        return max(fitting, key=lambda pair: pair[0])[1] if fitting else None


@cache
def classes() -> Classes:
    """The classes shipped with the service."""
    return Classes(json.loads(FILE.read_text(encoding="utf-8")))


def normal(text: str) -> str:
    """The form things are compared in: words apart, the last one singular."""
    found = words(text)
    if found[-1:] == ("glasses",) and found[-2:-1] and found[-2] in _DRUNK:
        return " ".join((*found[:-1], "glass"))  # Others are for the eyes.
    return " ".join((*found[:-1], _singular(found[-1]))) if found else ""


def _singular(word: str) -> str:
    """Of one thing; WordNet's odd plurals only where no plain one is meant: syringes, not syrinxes."""
    plainly = word.endswith("s") and nouns().knows(word[:-1])
    return singular(word, {} if plainly else nouns().irregular)


def _undetermined(found: tuple[str, ...]) -> tuple[str, ...]:
    while len(found) > 1 and found[0] in DETERMINERS and found[0] not in VAGUE:
        found = found[1:]
    return found


def _stems(found: Iterable[str]) -> frozenset[str]:
    return frozenset(stem(each) for each in found if each not in _FILLER and each not in VAGUE)


def _terms(entry: dict[str, object], key: str) -> list[str]:
    value = entry.get(key, "")
    return [each.strip() for each in str(value).split(",") if each.strip()]


def _listed(entry: dict[str, object], key: str) -> list[str]:
    return [normal(each) for each in _terms(entry, key)]
