"""Whether a thing belongs to a class, by the words of its name."""

from collections.abc import Iterable

from app.programs.knowledge.classes import (
    FIGURES,
    HOLDERS,
    PLAIN_ADJECTIVES,
    UNREAL,
    ThingClass,
    classes,
    normal,
)
from app.programs.knowledge.names import (
    DETERMINERS,
    PORTIONS,
    is_mark,
    singular,
    without_marks,
    words,
)
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns

LISTED, OPAQUE, PERHAPS, CERTAIN = 0.9, 0.4, 0.45, 1.0
TOYLIKE = frozenset(("toy", "stuffed", "plush", "pretend"))
"""Said before a noun, the thing is a toy."""
CUDDLY = frozenset(("stuffed", "plush", "cuddly"))
"""Said before a noun, the thing is a stuffed animal."""
CUTS = word_list("cuts")
"""Said after a noun, the thing is a part of it and of its class: a salmon fillet is fish."""


def belonging(name: str, kind: ThingClass) -> float:
    """How surely a thing of this name is one of the class, 0 to 1; from 0.5 on it counts."""
    core = head_first(name)
    if not core:
        return 0.0
    whole = normal(" ".join(without_marks(words(name))))
    if " " in whole and (whole in kind.never or whole in kind.members):
        return CERTAIN if whole in kind.members else 0.0  # A tin of tuna is listed as that.
    if kind.alone and _bare(name, core) in kind.alone:
        return CERTAIN
    before = {"toy": TOYLIKE, "stuffed animal": CUDDLY}.get(kind.name, frozenset())
    if before & set(core[:-1]) and normal(" ".join(core)) not in kind.never:
        return CERTAIN
    if kind.likenesses and len(core) > 1 and core[-1] in FIGURES:
        core = core[:-1]
    cut = len(core) > 1 and core[-1] in CUTS and not _word_of_its_own(core)
    direct = 0.0 if cut and _tells(core[:-1]) else _by_endings(core, kind)
    if not direct and cut:
        direct = 0.9 * _by_endings(core[:-1], kind)
    if kind.contents and direct < LISTED:
        held = _contents(name, core)
        direct = max([direct, *(0.85 * _by_endings(each, kind) for each in held)])
    return direct


def _bare(name: str, core: tuple[str, ...]) -> str:
    """The name without what is plainly said of it: an old jar is a jar, a jar of honey more."""
    if without_marks(words(name))[-len(core) :] != core:
        return ""
    start = 0
    while start < len(core) - 1 and core[start] in PLAIN_ADJECTIVES:
        start += 1
    return normal(" ".join(core[start:]))


def _word_of_its_own(core: tuple[str, ...]) -> bool:
    """Whether it is no part of something to eat: a signet ring is a ring."""
    eaten = classes().named("food")
    return nouns().knows(normal(" ".join(core))) and _by_endings(core[:-1], eaten) < PERHAPS


def _tells(core: tuple[str, ...]) -> bool:
    """Whether what is before a cut is known, and says of what it is cut: a salmon fillet is no meat."""
    return any(known(normal(" ".join(core))) for known in (classes().knows, nouns().knows))


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
