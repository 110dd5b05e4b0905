"""Words for things → what they ask for: noun, properties, place, and what is left out."""

import re
from dataclasses import dataclass, field, replace

from app.programs.knowledge.classes import VAGUE, classes
from app.programs.knowledge.names import DETERMINERS, words
from app.programs.knowledge.properties import (
    COLOUR_WORDS,
    FRUITY,
    MATERIALS,
    SIZES,
    SUPERLATIVES,
)
from app.programs.sketches.sketch import Phrase

SIDES = {
    "left": "left",
    "leftmost": "left",
    "right": "right",
    "rightmost": "right",
    "middle": "middle",
    "center": "middle",
    "centre": "middle",
    "central": "middle",
    "nearest": "near",
    "closest": "near",
    "front": "near",
    "farthest": "far",
    "furthest": "far",
    "back": "far",
    "rear": "far",
    "outer": "outer",
    "outermost": "outer",
    "outside": "outer",
    "ends": "outer",
    "sides": "outer",
    "edges": "outer",
    "upper": "top",
    "lower": "bottom",
}
_OF_SIDE = ("the", "hand", "side", "end", "far", "very", "thing", "things", "one", "ones", "both")
"""Words that a side is told with: "on the far right-hand side"."""
_ORDINALS = {"first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "last": -1}
_TAILS = (
    (
        r"(?:located |standing |lying |sitting )?(?:on|to|at) (?:the|my|your) (?:far |very |extreme )?(left|right)(?:[- ]hand)?(?: side| end)?",
        1,
    ),
    (
        r"(?:located |standing |lying |sitting )?(?:in|at) the (?:very )?(middle|center|centre|front|back)",
        1,
    ),
    (r"(?:at|on|towards) (?:both|either|the) (?:two |very |far )?(ends|sides|edges|outside)", 1),
    (r"furthest (?:to the )?(left|right)|farthest (?:to the )?(left|right)", 0),
    (r"from the (left|right)", 2),
    (r"(closest|nearest|farthest|furthest)(?: to (?:the robot|me|you|us)| away)?", 1),
)
_PLACES = (
    (r"(?:to the |on the )?left of", "left_of"),
    (r"(?:to the |on the )?right of", "right_of"),
    (r"(?:next to|beside|near(?:est)?(?: to)?|close(?:st)? to|by)", "near"),
    (r"in front of", "in_front_of"),
    (r"behind", "behind"),
    (r"inside(?: of)?|that (?:is|are) in", "inside"),
    (r"on top of|that (?:is|are) on", "on"),
)
_ENGLISH = frozenset(("the", "put", "and", "in", "on", "into", "a", "all", "to"))
SPOKEN_RELATIONS = {
    "left_of": frozenset(("left",)),
    "right_of": frozenset(("right",)),
    "near": frozenset(("near", "nearest", "next", "close", "closest", "beside", "by", "besides")),
    "inside": frozenset(("in", "inside", "from", "within", "out", "of")),
    "on": frozenset(("on", "from", "off", "top")),
    "behind": frozenset(("behind",)),
    "in_front_of": frozenset(("front",)),
}
"""Words of which one must stand in a sentence that speaks of the relation."""
_MADE = r"(?:(?:that (?:is|are) )?made (?:of|from|out of)|of) (?:a |some )?({})(?! \w)"
_PIECES = re.compile(
    r"^(?:the |an? )?(?:pieces?|items?|articles?|bits?|kinds?|types?|sorts?) of (?=\w)|"
    r"^things? (?=(?!that|it|what|who|there)\w+'s? (?:things?|stuff|gear|kit)$)",
    re.I,
)
_BETWEEN = re.compile(r"\b(?:(?:middle|mid|medium)[- ]sized?|in[- ]between)\b(?= \w)", re.I)
"""Of medium size; "middle" alone is a place."""
_NOT = r"(?:that|which|who) (?:(?:is|are|was|were) not|isn't|aren't|do not|don't) (?:an? |in |made of )?(.+)"
_IS = r"(?:that|which|who) (?:is|are|'s) (?:an? |in )?(.+)"


@dataclass(frozen=True, slots=True, kw_only=True)
class Description:
    """What a phrase asks for; all that is not given does not matter."""

    text: str
    """The words as they were."""
    core: tuple[str, ...]
    """Noun with what is no property, lower case."""
    whole: tuple[str, ...] = ()
    """The noun with its properties."""
    colours: frozenset[str] = frozenset()
    materials: frozenset[str] = frozenset()
    sizes: frozenset[int] = frozenset()
    side: str | None = None
    superlative: int = 0
    """1 for the largest, -1 for the smallest."""
    ordinal: int = 0
    ordinal_from: str = "left"
    other: bool = False
    """None of those that were spoken of before."""
    relations: tuple[tuple[str, str], ...] = ()
    excluded: tuple["Description", ...] = field(default=())

    @property
    def vague(self) -> bool:
        """Whether no noun says what it is: "the red ones", "everything"."""
        return not self.core or all(each in VAGUE for each in self.core)


def describe_phrase(phrase: Phrase) -> Description:
    """Read the phrase's words and its qualifiers."""
    found = read_description(phrase.text)
    if phrase.where:
        inner = read_description(f"{phrase.where} x")
        found = replace(
            found,
            side=inner.side or found.side,
            superlative=inner.superlative or found.superlative,
            ordinal=inner.ordinal or found.ordinal,
        )
    for key, other in phrase.relations:
        side = SIDES.get(" ".join(each for each in words(other) if each not in _OF_SIDE))
        if side:  # "on the left" is no thing that something stands on.
            found = replace(found, side=side)
        else:
            found = replace(found, relations=(*found.relations, (key, other)))
    left_out = tuple(read_description(each) for each in phrase.but)
    return replace(found, excluded=(*found.excluded, *left_out))


def spoken_of(phrase: Phrase, sentence: str) -> Phrase:
    """The phrase without relations that an English sentence has no word for."""
    said = set(words(sentence))
    if not said & _ENGLISH or not phrase.relations:
        return phrase
    kept = tuple((key, other) for key, other in phrase.relations if said & SPOKEN_RELATIONS[key])
    around = [(key, other) for key, other in kept if other == phrase.text]
    if around and around[0][0] in ("inside", "on"):  # What is in the flask is the flask's.
        kept = tuple(pair for pair in kept if pair not in around)
    elif around:
        return replace(phrase, text="thing", relations=kept)
    return replace(phrase, relations=kept)


def read_description(text: str) -> Description:
    """Read plain words."""
    rest = _coloured(_PIECES.sub("", _BETWEEN.sub("medium", " ".join(text.split()))))
    read = Description(text=rest, core=())
    rest, read = _negated(rest, read)
    rest, read = _placed(rest, read)
    rest, read = _tailed(rest, read)
    rest, read = _made(rest, read)
    rest, read = _called(rest, read)
    return _adjectives(words(rest), read)


def _coloured(text: str) -> str:
    """Whites are white things; greens and oranges are something to eat."""
    colour = text.lower().removesuffix("s")
    if colour != text.lower() and colour in COLOUR_WORDS and colour not in FRUITY | {"green"}:
        return f"{colour} things"
    return text


def _negated(rest: str, read: Description) -> tuple[str, Description]:
    if match := re.search(rf"\b{_NOT}$", rest, re.I):
        inner = read_description(match[1])
        return rest[: match.start()].strip(), replace(read, excluded=(inner,))
    if match := re.search(
        r"(?<=.)\b(?:except|but not|but|other than|besides|apart from)(?: for)? (.+)$", rest, re.I
    ):
        inner = read_description(match[1])
        return rest[: match.start()].strip(), replace(read, excluded=(inner,))
    if match := re.match(r"(?:the )?(?:non[- ]|not )(\w+)\b", rest, re.I):
        inner = read_description(match[1])
        return rest[match.end() :].strip() or "things", replace(read, excluded=(inner,))
    return rest, read


def _placed(rest: str, read: Description) -> tuple[str, Description]:
    for pattern, key in _PLACES:
        match = re.search(
            rf"\s(?:that (?:is|are) |which (?:is|are) |located |standing |lying )?(?:{pattern}) (.+)$",
            rest,
            re.I,
        )
        if match:
            other = match[1].strip()
            return rest[: match.start()].strip(), replace(read, relations=((key, other),))
    return rest, read


def _tailed(rest: str, read: Description) -> tuple[str, Description]:
    for pattern, group in _TAILS:
        if match := re.search(
            rf"\s(?:that (?:is|are) |which (?:is|are) )?(?:{pattern})$", rest, re.I
        ):
            said = next(each for each in match.groups() if each).lower()
            left = rest[: match.start()].strip()
            if group == 2:
                return left, replace(read, ordinal_from=said)
            return left, replace(read, side=SIDES[said])
    return rest, read


def _made(rest: str, read: Description) -> tuple[str, Description]:
    pattern = _MADE.format("|".join(MATERIALS))
    if match := re.search(rf"\s{pattern}$", rest, re.I):
        material = frozenset((MATERIALS[match[1].lower()],))
        return rest[: match.start()].strip(), replace(read, materials=material)
    return rest, read


def _called(rest: str, read: Description) -> tuple[str, Description]:
    """``things that are red``: what follows is one more description."""
    if match := re.search(rf"\s{_IS}$", rest, re.I):
        inner = read_description(match[1])
        if not inner.core:
            return rest[: match.start()].strip(), replace(
                read, colours=inner.colours, materials=inner.materials, sizes=inner.sizes
            )
    return rest, read


def _adjectives(found: tuple[str, ...], read: Description) -> Description:
    """The words before the noun that tell a property, a place or an order."""
    if len(found) > 2 and found[0] in VAGUE and found[1] in _CLAUSE:
        return replace(read, core=found, whole=found)
    core: list[str] = []
    colours, materials, sizes = set(read.colours), set(read.materials), set(read.sizes)
    for place, word in enumerate(found):
        head, alone = place == len(found) - 1, place == 0
        if word in COLOUR_WORDS and (not head or (alone and word not in FRUITY)):
            colours.add(COLOUR_WORDS[word])
        elif word in MATERIALS and not head:
            materials.add(MATERIALS[word])
        elif word in SIZES and (not head or alone):
            sizes.add(SIZES[word])
        elif ranked := _ranking(word, read, head=head, alone=alone):
            read = ranked
        elif word not in _SILENT or head:
            core.append(word)
    return replace(
        read,
        core=_core(tuple(core)),
        whole=_core(found),
        colours=frozenset(colours),
        materials=frozenset(materials),
        sizes=frozenset(sizes),
    )


_CLAUSE = ("you", "that", "to", "for", "used", "which", "i", "we", "with", "one", "people", "from")
"""After "thing" they begin what the thing is for; no word of that is a property."""
_SILENT = ("colored", "coloured", "sized", "hand", "most", "single", "and")
"""Words before a noun that say nothing of it."""


def _ranking(word: str, read: Description, *, head: bool, alone: bool) -> Description | None:
    """With what the word says of side, order or "other", if it does."""
    if word in SIDES and (not head or alone):
        return replace(read, side=SIDES[word])
    if head:
        return None
    if word in SUPERLATIVES:
        return replace(read, superlative=SUPERLATIVES[word])
    if word in _ORDINALS:
        return replace(read, ordinal=_ORDINALS[word])
    return replace(read, other=True) if word == "other" else None


def _core(found: tuple[str, ...]) -> tuple[str, ...]:
    while len(found) > 1 and (found[0] in DETERMINERS or found[0].endswith(("'s", "s'"))):
        if "'" in found[0] and set(found[1:]) <= VAGUE and classes().find(" ".join(found)):
            break  # "the doctor's things" are a class of their own.
        found = found[1:]
    return found
