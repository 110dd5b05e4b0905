"""Which of several targets shares a property with a thing: its colour, its material, its class."""

import re
from collections.abc import Callable, Sequence

from app.programs.knowledge.classes import VAGUE, normal
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.names import is_mark
from app.programs.knowledge.properties import COLOUR_WORDS, MATERIALS, SIZES
from app.programs.knowledge.synonyms import mean_the_same
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.matching import find_class
from app.programs.sketches.sketch import Phrase, Same
from app.programs.sketches.things import Thing

NAMES = {"color": "colour", "kind": "category", "type": "category", "class": "category"}
SHAPES = word_list("shapes")


def said_to_share(phrase: Phrase) -> Same | None:
    """What "the tray named after it", "its own box" and "the matching bin" mean: one of the kind."""
    match = _SHARING.match(phrase.text.lower())
    return Same("category", match[match.lastgroup or 0]) if match else None


_SHARING = re.compile(
    r"(?:(?:its|their|his|her|own|matching|corresponding|respective|appropriate)\s+)+(?P<own>[\w ]+)$|"
    r"(?P<after>[\w ]+?) (?:named|called|labelled|labeled|marked) (?:after|for|with) (?:it|them)$|"
    r"(?P<kind>\w+) (?:of|for) its own(?: kind| sort| type)?$"
)


def sharing(thing: Thing, targets: Sequence[Thing], key: str) -> list[Thing]:
    """The targets that have the same; several only where they are equally like it."""
    key = NAMES.get(key, key)
    match key:
        case "colour":
            return _sharing_words(thing.colours(), targets, Thing.colours)
        case "material":
            found = _sharing_words(thing.materials(), targets, Thing.materials)
            return found or _by_likely_material(thing, targets)
        case "size":
            return _by_size(thing, targets)
        case _:
            told = thing.property(key)
            alike = [t for t in targets if told and t.property(key) == told]
            return alike or _by_class(thing, targets)


def _sharing_words(
    mine: frozenset[str], targets: Sequence[Thing], of: Callable[[Thing], frozenset[str]]
) -> list[Thing]:
    return [target for target in targets if mine & of(target)]


def _by_likely_material(thing: Thing, targets: Sequence[Thing]) -> list[Thing]:
    scored = [
        (max((thing.has_material(m) for m in target.materials()), default=0.0), target)
        for target in targets
    ]
    best = max((score for score, _ in scored), default=0.0)
    return [target for score, target in scored if score == best and best >= 0.5]


def _by_size(thing: Thing, targets: Sequence[Thing]) -> list[Thing]:
    size = thing.told_size()
    return [target for target in targets if size is not None and target.told_size() == size]


def _by_class(thing: Thing, targets: Sequence[Thing]) -> list[Thing]:
    """The target whose name says what it is for: a toy box is for toys."""
    scored = [(_meant_for(target, thing), target) for target in targets]
    best = max((score for score, _ in scored), default=0.0)
    return [target for score, target in scored if score == best and best >= 0.5]


def _meant_for(target: Thing, thing: Thing) -> float:
    told = target.words[:-1] if len(target.words) > 1 else target.words
    marks = [each for each in told if not is_mark(each) and each not in VAGUE]
    if "for" in marks:
        marks = marks[marks.index("for") + 1 :]
    wanted = normal(" ".join(marks))
    if not wanted:
        return 0.0
    if wanted in COLOUR_WORDS:
        return 1.0 if COLOUR_WORDS[wanted] in thing.colours() else 0.0
    if wanted in SIZES:
        return 1.0 if SIZES[wanted] == thing.told_size() else 0.0
    if mean_the_same(wanted, thing.unmarked) or wanted in {normal(each) for each in thing.words}:
        return 1.0
    if thing.item.category and mean_the_same(normal(thing.item.category), wanted):
        return 1.0
    if kind := find_class(wanted) or find_class(f"{wanted} thing"):
        return belonging(thing.name, kind)
    return thing.has_material(MATERIALS[wanted]) if wanted in MATERIALS else 0.0
