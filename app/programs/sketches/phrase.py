"""Words for things → what they ask for: noun, properties, place, and what is left out."""

import re
from dataclasses import replace

from app.programs.knowledge.classes import VAGUE, classes
from app.programs.knowledge.names import DETERMINERS, words
from app.programs.knowledge.properties import (
    COLOUR_WORDS,
    COLOURS,
    FRUITY,
    MATERIALS,
    SIZES,
    SUPERLATIVES,
)
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.description import Description
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.whereabouts import SIDES, at_side, placed, side_of

_ORDINALS = {"first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "last": -1}
_MADE = r"(?:(?:that (?:is|are) )?made (?:of|from|out of)|of) (?:a |some )?({})(?! \w)"
_PIECES = re.compile(
    r"^(?:the |an? )?(?:pieces?|items?|articles?|bits?|kinds?|types?|sorts?) of (?=\w)|"
    r"^things? (?=(?!that|it|what|who|there)\w+'s? (?:things?|stuff|gear|kit)$)",
    re.I,
)
_BETWEEN = re.compile(r"\b(?:(?:middle|mid|medium)[- ]sized?|in[- ]between)\b(?= \w)", re.I)
"""Of medium size; "middle" alone is a place."""
_DYED = re.compile(
    r"(?:the |my |our )?(?:(?:colou?reds|(?P<dark>darks))(?: one)?|colou?red "
    r"(?P<what>things?|items?|clothes|clothing|washing|laundry|garments|ones|stuff))",
    re.I,
)
"""Beside whites: washing of another colour."""
_DARK = frozenset(("black", "blue", "brown", "grey", "purple", "red", "green"))
_NOT = r"(?:that|which|who) (?:(?:is|are|was|were) not|isn't|aren't|do not|don't) (?:an? |in |made of )?(.+)"
_IS = r"(?:that|which|who) (?:is|are|'s) (?:an? |in )?(.+)"


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
        if side := side_of(other):  # "on the left" is no thing that something stands on.
            found = replace(found, side=side)
        else:
            found = replace(found, relations=(*found.relations, (key, other)))
    left_out = tuple(read_description(each) for each in phrase.but)
    return replace(found, excluded=(*found.excluded, *left_out))


def read_description(text: str) -> Description:
    """Read plain words."""
    rest = _coloured(_PIECES.sub("", _BETWEEN.sub("medium", " ".join(text.split()))))
    read = Description(text=rest, core=())
    if dyed := _DYED.fullmatch(rest):
        rest = dyed["what"] or "things"
        read = replace(read, colours=_DARK if dyed["dark"] else frozenset(COLOURS) - {"white"})
    rest, read = _negated(rest, read)
    rest, read = placed(rest, read)
    rest, read = at_side(rest, read)
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
        core=_found(_core(tuple(core)), told=bool(colours or materials)),
        whole=_core(found),
        colours=frozenset(colours),
        materials=frozenset(materials),
        sizes=frozenset(sizes),
    )


_CLAUSE = ("you", "that", "to", "for", "used", "which", "i", "we", "with", "one", "people", "from")
"""After "thing" they begin what the thing is for; no word of that is a property."""
_FINDS = word_list("finds")
"""What is made of metal, or is red, is called so whatever it is."""
_STATES = frozenset(("open", "opened", "closed", "shut", "unlocked"))
"""Said of things to be shut or opened."""
_SILENT = ("colored", "coloured", "sized", "hand", "most", "single", "and")
"""Words before a noun that say nothing of it."""


def _found(core: tuple[str, ...], *, told: bool) -> tuple[str, ...]:
    """Things, for finds and the like of which a property is ``told``."""
    finds = told and len(core) == 1 and core[0] in _FINDS
    state = len(core) == 2 and core[0] in _STATES and core[1] in VAGUE
    return ("things",) if finds or state else core


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
