"""Words for where things are, within a phrase: "on the far left", "next to the plate"."""

import re
from dataclasses import replace

from app.programs.knowledge.names import words
from app.programs.sketches.description import Description
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


def side_of(text: str) -> str | None:
    """The side that the words name and nothing else: "the right-hand side"."""
    return SIDES.get(" ".join(each for each in words(text) if each not in _OF_SIDE))


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


def as_said(phrase: Phrase, sentence: str) -> Phrase:
    """With the side that the sentence says before the words, where the sketch has another, or none."""
    spoken = r"\s+".join(map(re.escape, phrase.text.split()))
    if phrase.quantity != "one" or phrase.relations or not spoken:
        return phrase
    if phrase.where and (phrase.where not in SIDES or phrase.where in words(sentence)):
        return phrase
    if phrase.where and set(_BEFORE) & set(words(phrase.text)):
        return replace(phrase, where=None)
    pattern = rf"\b(?:(?P<side>{'|'.join(_BEFORE)})(?:[- ]hand)? )?{spoken}\b"
    found = [match["side"] for match in re.finditer(pattern, sentence, re.I)]
    if len(found) != 1 or found[0] is None:
        return phrase
    return replace(phrase, where=found[0].lower())


_BEFORE = ("leftmost", "left", "rightmost", "right", "middle", "center", "centre", "central")
"""Sides that are said before a noun."""


def placed(rest: str, read: Description) -> tuple[str, Description]:
    """Without the words that place it by another thing."""
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


def at_side(rest: str, read: Description) -> tuple[str, Description]:
    """Without the words that tell a side of all."""
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
