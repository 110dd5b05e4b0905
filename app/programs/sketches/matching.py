"""How well the words for a thing fit an object of the scene: by name, synonym, class, or a slip.

The score says which kind of evidence there is; a better kind always wins over a worse one.
"""

import difflib
from collections.abc import Sequence
from functools import lru_cache

from app.programs.knowledge.bearing import VESSELS, holds_another, holds_the_same
from app.programs.knowledge.classes import (
    HOLDERS,
    PLAIN_ADJECTIVES,
    UNREAL,
    VAGUE,
    ThingClass,
    classes,
    normal,
)
from app.programs.knowledge.membership import belonging, endings
from app.programs.knowledge.names import NUMBERS, is_mark, plain, stem
from app.programs.knowledge.properties import FRUITY
from app.programs.knowledge.synonyms import mean_the_same
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns
from app.programs.sketches.description import Description
from app.programs.sketches.things import Thing

EXACT, SAME_WORDS, UNMARKED, HEAD, SYNONYM, MEMBER, KIND = 1.0, 0.98, 0.95, 0.92, 0.85, 0.8, 0.72
WIDER, MODIFIER, LOOSE, SLIP = 0.62, 0.56, 0.52, 0.5
COUNTS = 0.5
"""From here on an object fits."""
SETS = 0.7
"""From here on it is a member of a set, whatever else fits better."""
_SLIP = 0.78
_SORTS = frozenset(
    ("brick", "set", "piece", "unit", "toy", "spool", "reel", "skein", "bobbin", "bar", "cube")
)
"""Heads of a name that say less than what stands before them."""
_CASES = frozenset(("box", "basket", "case", "bin", "bag", "chest"))
_DISTRUSTED = frozenset(
    (("scissors", "tool"), ("book", "stationery"), ("block", "toy"), ("ball", "toy"))
)
"""What a catalogue says of its kinds, but people would not."""


_OPAQUE = word_list("opaque")
"""Names that are not what their last word says."""


def fit(thing: Thing, described: Description) -> float:
    """How well the noun fits, 0 to 1, whatever the properties."""
    if plain(thing.name).strip() == plain(described.text).strip():
        return EXACT
    if not thing.words:
        return MEMBER if described.vague else 0.0
    if described.vague and not described.whole:
        return MEMBER
    cores = {described.whole, described.core}
    cores |= {_turned(core) for core in cores}
    best = max((_words_fit(thing, core) for core in cores if core), default=0.0)
    if best < COUNTS and thing.english:
        best = 0.9 * fit(thing.english, described)
    return max(best, MEMBER) if described.vague else best


def _turned(core: tuple[str, ...]) -> tuple[str, ...]:
    """A jar of honey is a honey jar."""
    if "of" not in core[1:-1]:
        return core
    place = core.index("of", 1)
    return (*core[place + 1 :], *core[:place])


def _words_fit(thing: Thing, core: tuple[str, ...]) -> float:
    """The best kind of evidence that these words, head last, mean the thing."""
    if len(core) == 1 and core[0] == dict(thing.item.properties).get("material", "").lower():
        return MEMBER  # "the glass goes to the green bin"
    if core[-1] == "glasses" and thing.core[-1:] == ("glass",):
        core = (*core[:-1], "glass")  # They are to drink from, then.
    wanted = normal(" ".join(core))
    if thing.words == core or normal(" ".join(thing.words)) == wanted:
        return SAME_WORDS
    if (
        thing.unmarked in (wanted, wanted.removesuffix("es"))
        or _without_numbers(core) == thing.words
    ):
        return UNMARKED
    if all(each in VAGUE for each in core):
        return 0.0
    found = _known_fit(thing, wanted)
    use = core[0] in VAGUE and core[1:2] in (("to",), ("that",), ("which",))
    if found >= HEAD or len(core) == 1 or use:  # Something to light the candle is no candle.
        return found
    if holds_the_same(thing.name, core):
        return KIND
    return max(found, _modified_fit(thing, core))


def _known_fit(thing: Thing, wanted: str) -> float:
    head = normal(thing.core[-1]) if thing.core else ""
    if ends := _ends_with(thing.core, wanted):
        return ends
    names = tuple(endings(thing.core))
    kind = find_class(wanted)
    if kind and _member(thing, kind) >= COUNTS:
        return MEMBER
    if any(mean_the_same(each, wanted) for each in names[:1]):
        return SYNONYM if kind is None else SETS - 0.01
    if _declared(thing, wanted, kind):
        return MEMBER
    if mean_the_same(head, wanted) and _transparent(thing):
        return SYNONYM - 0.01
    if kind is None and _kind(names, wanted):
        return KIND
    return _loose_fit(thing, wanted, names)


def _loose_fit(thing: Thing, wanted: str, names: Sequence[str]) -> float:
    if nouns().kind_of(wanted, names[0]) >= 0.4 and not find_class(wanted):
        return WIDER
    if names[0] in classes().names() and belonging(wanted, classes().named(names[0])) >= 0.8:
        return WIDER
    said, had = wanted.split(), [normal(each) for each in thing.words]
    head = normal(thing.core[-1]) if thing.core else ""
    opaque = normal(" ".join(thing.core)) in _OPAQUE
    holds = head in HOLDERS and not opaque and (len(said) > 1 or _is_held(thing, wanted))
    told = holds or head in _SORTS
    if set(said) <= set(had) and (told or _holds(thing, wanted)):
        return MODIFIER
    stems, others = {stem(each) for each in said}, {stem(each) for each in thing.words}
    known = classes().knows(wanted) and wanted not in PLAIN_ADJECTIVES - FRUITY
    if stems <= others and min(map(len, stems)) > 3 and not known:
        return LOOSE
    return 0.0


def _holds(thing: Thing, wanted: str) -> bool:
    """Whether it is a ``plate of cookies`` where cookies are wanted."""
    return "of" in thing.words and normal(" ".join(thing.words)).endswith(f" of {wanted}")


def _is_held(thing: Thing, wanted: str) -> bool:
    """Whether all that the container holds ends with the word: juice, and no apple, is in a ``juice carton``."""
    after = thing.words[thing.words.index("of") + 1 :] if "of" in thing.words else ()
    before = after or thing.core[:-1]
    return not before or normal(" ".join(before)).split()[-1] == wanted


def _modified_fit(thing: Thing, core: tuple[str, ...]) -> float:
    """The head fits; what stands before it must show in the name, or be unknown."""
    if holds_another(thing.name, " ".join(core[:-1])):
        return 0.0
    for start in range(1, len(core)):
        head = _known_fit(thing, normal(" ".join(core[start:])))
        if head < COUNTS:
            continue
        if len(core) == start + 1 == 2 and _rivals(thing, core[0]):
            return 0.0
        # Of a class that has a name of its own nothing is one for being of two others.
        own = find_class(normal(" ".join(core))) is not None
        shown = [_shows(thing, each, own=own) for each in core[:start] if not is_mark(each)]
        if any(is_mark(each) for each in core[:start]) and not shown:
            return 0.0
        if shown and all(shown):
            return min(head, HEAD) - 0.02
        # Of "old oil filter", an oil filter has more than an air filter.
        return min(head, WIDER) - 0.06 + 0.02 * (len(core) - start - 1) if head >= KIND else 0.0
    return 0.0


def _rivals(thing: Thing, modifier: str) -> bool:
    """Whether the name has another of the same kind in the modifier's place: dog food is no cat food."""
    if len(thing.core) != 2 or is_mark(modifier):
        return False
    own, wanted = normal(thing.core[0]), normal(modifier)
    return not mean_the_same(own, wanted) and classes().share(own, wanted)


def _shows(thing: Thing, modifier: str, *, own: bool) -> bool:
    """Whether the name, the category or, if not ``own``, the class of the thing bears the modifier out."""
    wanted = normal(modifier)
    if wanted in {normal(each) for each in thing.words} or stem(modifier) in map(stem, thing.words):
        return True
    kind = None if own else find_class(f"{modifier} thing")
    if kind and _member(thing, kind) >= COUNTS:
        return True
    return bool(thing.item.category and wanted in plain(thing.item.category).split())


def _member(thing: Thing, kind: ThingClass) -> float:
    named = belonging(thing.name, kind)
    if named < COUNTS and not classes().knows(thing.unmarked):
        described = thing.item.category
        if described and described != "object":
            named = max(named, _category(described, kind))
    return named


def _category(described: str, kind: ThingClass) -> float:
    other = classes().find(described)
    return 0.85 if other and other.name == kind.name else 0.85 * belonging(described, kind)


def _declared(thing: Thing, wanted: str, kind: ThingClass | None) -> bool:
    """Whether the scene says that it is one."""
    described = thing.item.category
    if not described or described == "object":
        return False
    head = normal(thing.core[-1]) if thing.core else ""
    if (head, described) in _DISTRUSTED:
        return False
    if mean_the_same(normal(described), wanted):
        return True
    other = classes().find(described)
    return bool(kind and other and kind.name == other.name)


def _kind(names: Sequence[str], wanted: str) -> bool:
    """Whether WordNet has the name, or its head, as a kind of what is wanted."""
    for place, name in enumerate(names):
        if nouns().kind_of(name, wanted) >= 0.5:
            return True
        if place == 0 and (classes().knows(name) or nouns().knows(name)) and " " in name:
            return False
    return False


def _ends_with(core: tuple[str, ...], wanted: str) -> float:
    """Whether the name's last words are these: a ``coffee mug`` is a mug, a ``football`` a ball."""
    if not core:
        return 0.0
    name = normal(" ".join(core))
    if name == wanted or name.endswith(f" {wanted}"):
        kind = find_class(wanted)
        return 0.0 if name in _OPAQUE or (kind and name in kind.never) else HEAD
    head = name.split()[-1]
    closed = head.endswith(wanted) and len(wanted) > 2 and len(head) > len(wanted)
    kind = classes().find(wanted)
    if closed and kind:
        return (HEAD - 0.03) * (belonging(head, kind) >= COUNTS)
    if closed and len(wanted) > 3 and misspelt(head) and not misspelt(head.removesuffix(wanted)):
        return HEAD - 0.03  # A ragdoll, though no dictionary has it, is a doll.
    if closed and wanted in VESSELS | HOLDERS | _CASES and _contains(head):
        return HEAD - 0.03
    return (HEAD - 0.03) * (closed and nouns().kind_of(head, wanted) >= 0.3)


def _contains(name: str) -> bool:
    """Whether it is a container, as far as anybody knows: a ``hatbox``, but no ``jukebox``."""
    kind = classes().named("container")
    return belonging(name, kind) >= COUNTS or not (nouns().knows(name) or classes().knows(name))


def _transparent(thing: Thing) -> bool:
    """Whether its name means what its head means, and is no likeness of it."""
    if normal(" ".join(thing.core)) in _OPAQUE:
        return False
    return not (UNREAL & set(thing.core[:-1])) and not nouns().knows(" ".join(thing.core))


def slip(thing: Thing, described: Description) -> float:
    """How likely the words are the thing's name with a typing slip in them."""
    core = described.core or described.whole
    if not core or not thing.words:
        return 0.0
    if not any(misspelt(each) for each in core):
        return 0.0
    whole = _alike(" ".join(core), " ".join(thing.words))
    last = max(_alike(core[-1], thing.words[-1]), _alike(core[-1], (thing.core or core)[-1]))
    rest = (max(_alike(each, other) for other in thing.words) for each in core[:-1])
    return max(whole, min((last, *rest)) - 0.02)


def misspelt(word: str) -> bool:
    """Whether no dictionary at hand knows the word."""
    return not any(
        known(each) for known in (nouns().knows, classes().knows) for each in (word, normal(word))
    )


def _alike(word: str, other: str) -> float:
    if not misspelt(word) and word != other:
        return 0.0
    ratio = difflib.SequenceMatcher(None, word, other).ratio()
    swapped = sorted(word) == sorted(other) and word[:1] == other[:1]
    return max(ratio, 0.9) if swapped else ratio if ratio >= _SLIP else 0.0


@lru_cache(maxsize=4096)
def find_class(wanted: str) -> ThingClass | None:
    """The class the words name."""
    return classes().find(wanted)


def _without_numbers(core: tuple[str, ...]) -> tuple[str, ...]:
    return (*core[:-1], NUMBERS.get(core[-1], core[-1])) if len(core) > 1 else core
