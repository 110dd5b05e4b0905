"""Classes of things as people speak of them, and whether a thing belongs to one.

``static/knowledge/classes.json`` holds what WordNet has wrong or does not know: for each class its
other names, its nouns, what counts as one only perhaps, what never does, where in WordNet more are
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
    is_mark,
    singular,
    stem,
    without_marks,
    words,
)
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "classes.json"
LISTED, OPAQUE, PERHAPS, CERTAIN = 0.9, 0.4, 0.45, 1.0
VAGUE = word_list("vague")
_FILLER = word_list("filler")
UNREAL = word_list("unreal")
"""Said before a noun, the thing is a likeness of it."""
TOYLIKE = frozenset(("toy", "stuffed", "plush", "pretend"))
"""Said before a noun, the thing is a toy."""
CUDDLY = frozenset(("stuffed", "plush", "cuddly"))
"""Said before a noun, the thing is a stuffed animal."""
PLAIN_ADJECTIVES = word_list("plain_adjectives")
FIGURES = word_list("figures")
"""Said after a noun, the thing is a likeness of it."""
LIVELY = word_list("lively")
"""Classes whose likenesses count as members: a toy truck is a vehicle on a table."""
HOLDERS = word_list("holders")
CUTS = word_list("cuts")
"""Said after a noun, the thing is a part of it and of its class: a salmon fillet is fish."""


_DRUNK = word_list("drunk")
"""Said before "glasses", they are to drink from."""


@dataclass(frozen=True, slots=True)
class ThingClass:
    """One class; all words as ``normal`` makes them."""

    name: str
    members: frozenset[str]
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
        for key in ("nouns", "perhaps"):
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


def belonging(name: str, kind: ThingClass) -> float:
    """How surely a thing of this name is one of the class, 0 to 1; from 0.5 on it counts."""
    core = _core(name)
    if not core:
        return 0.0
    before = {"toy": TOYLIKE, "stuffed animal": CUDDLY}.get(kind.name, frozenset())
    if before & set(core[:-1]) and normal(" ".join(core)) not in kind.never:
        return CERTAIN
    if kind.likenesses and len(core) > 1 and core[-1] in FIGURES:
        core = core[:-1]
    cut = len(core) > 1 and core[-1] in CUTS
    direct = 0.0 if cut and _tells(core[:-1]) else _by_endings(core, kind)
    if not direct and cut:
        direct = 0.9 * _by_endings(core[:-1], kind)
    if kind.contents and direct < LISTED:
        held = _contents(name, core)
        direct = max([direct, *(0.85 * _by_endings(each, kind) for each in held)])
    return direct


def _tells(core: tuple[str, ...]) -> bool:
    """Whether what is before a cut is known, and says of what it is cut: a salmon fillet is no meat."""
    return any(known(normal(" ".join(core))) for known in (classes().knows, nouns().knows))


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


def endings(core: tuple[str, ...]) -> Iterable[str]:
    """The name, and what is left of it from the second word on, and so on; the head comes last."""
    for start in range(len(core)):
        yield normal(" ".join(core[start:]))


def head_first(name: str) -> tuple[str, ...]:
    """The words up to the head: a ``bowl of soup`` is a bowl, a ``slice of cheese`` cheese."""
    found = list(without_marks(words(name)))
    for link in ("of", "with", "for", "from", "in", "on", "full", "without"):
        if link in found[1:-1]:
            place = found.index(link, 1)
            if link == "full" and found[place + 1] != "of":
                continue
            before = found[:place]
            portion = link == "of" and singular(before[-1]) in PORTIONS
            found = found[place + 1 :] if portion else before
            while len(found) > 1 and (found[0] in DETERMINERS or found[0].isdigit()):
                found = found[1:]
    while len(found) > 1 and (found[0] in DETERMINERS or is_mark(found[-1])):
        found = found[1:] if found[0] in DETERMINERS else found[:-1]
    return tuple(found)


_core = head_first


def _contents(name: str, core: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
    """What a container named after its contents holds: ``ketchup`` of a ``ketchup bottle``."""
    found: list[tuple[str, ...]] = []
    if len(core) > 1 and {core[-1], singular(core[-1])} & HOLDERS:
        found.append(core[:-1])
    whole = words(name)
    if "of" in whole[1:-1]:
        found.append(whole[whole.index("of") + 1 :])
    return tuple(found)


def _by_endings(core: tuple[str, ...], kind: ThingClass) -> float:
    known = classes()
    longest: str | None = None
    unreal = bool(UNREAL & set(core[:-1])) and not kind.likenesses
    for ending in endings(core):
        if ending in kind.never:
            return 0.0
        seen = known.knows(ending) or nouns().knows(ending)
        found = _one(ending, kind)
        if found:
            if longest and not _clear(longest, ending, kind):
                return min(found, OPAQUE)
            whole = longest is None and ending == normal(" ".join(core))
            likeness = unreal and not whole and kind.name not in _MATERIAL_CLASSES
            return 0.3 if likeness else found
        if seen and longest is None:
            longest = ending
    return 0.0


_MATERIAL_CLASSES = ("toy", "plastic object", "stuffed animal", "soft object", "building toy")


def _clear(longest: str, ending: str, kind: ThingClass) -> bool:
    """Whether the compound is a kind of what it ends with: a claw hammer, not a computer mouse."""
    extra = longest.removesuffix(ending).split()
    if set(extra) <= PLAIN_ADJECTIVES or (kind.likenesses and set(extra) <= UNREAL):
        return True
    if classes().share(longest, ending):
        return True
    if nouns().knows(longest):
        return nouns().kind_of(longest, ending) >= 0.5
    return not (kind.contents and classes().knows(longest))


def _one(noun: str, kind: ThingClass) -> float:
    if noun in kind.members:
        return CERTAIN
    if noun in kind.perhaps:
        return PERHAPS
    if not kind.roots:
        return 0.0
    if any(nouns().kind_of(noun, each) >= 0.5 for each in kind.never):
        return 0.0
    return LISTED * nouns().is_a(noun, kind.roots)


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
