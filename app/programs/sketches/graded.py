"""A tower of one kind by size: "stack the three tins, the biggest at the bottom and the smallest on top".

Which of them is the biggest the scene tells, and not the sentence: the one that the model reads says
what goes onto what by name.
"""

import re
from itertools import pairwise

from app.programs.knowledge.names import NUMBERS
from app.programs.sketches.naming import Naming
from app.programs.sketches.qualities import ordered
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import Thing

_LARGE = r"(?:biggest|largest|widest|heaviest|broadest|big(?:gest)? ones?|large ones?)"
_SMALL = r"(?:smallest|littlest|tiniest|narrowest|lightest|small(?:est)? ones?|little ones?)"
_AT_BOTTOM = (
    r"(?: one)?(?: (?:goes|should go|is|being))?,? (?:at|on) (?:the )?(?:very )?(?:bottom|base)"
)
_ON_TOP = r"(?: one)?(?: (?:goes|should go|is|being))?,? (?:on|at) (?:the )?(?:very )?top"
_THE = r"(?:the |with the )*"
_NUMBER = "|".join(NUMBERS)
_STACKED = re.compile(
    r"\b(?:stack|pile|heap)(?: up)?(?: all)?(?: of)? (?:the|my|our|these|those)"
    rf" (?:(?:{_NUMBER}|\d) )?(?P<what>[\w'-]+(?: [\w'-]+)??)(?: up)?"
    r"(?: (?:on|onto|in) (?:the|my|that) (?P<base>[\w' -]+?))?(?=,| with\b| from\b| in order\b| by size\b| (?:big|larg|small)\w+ (?:first|to)\b)",
    re.I,
)
_LARGEST_BELOW = re.compile(
    rf"\b{_LARGE}{_AT_BOTTOM}|\b{_SMALL}{_ON_TOP}|\b(?:from )?{_THE}{_LARGE} (?:to|up to|down to) {_THE}{_SMALL}|"
    rf"\b{_LARGE} first|\bby size\b|\bin order of size\b|\b{_SMALL} last\b",
    re.I,
)
_SMALLEST_BELOW = re.compile(
    rf"\b{_SMALL}{_AT_BOTTOM}|\b{_LARGE}{_ON_TOP}|\b(?:from )?{_THE}{_SMALL} (?:to|up to) {_THE}{_LARGE}|\b{_SMALL} first\b",
    re.I,
)
FEWEST = 2


def graded(sentence: str, selection: Selection) -> str:
    """The sentence with what goes onto what; as it is where the scene does not tell the sizes."""
    match = _STACKED.search(sentence)
    if match is None:
        return sentence
    below, above = (bool(each.search(sentence)) for each in (_LARGEST_BELOW, _SMALLEST_BELOW))
    if below == above:
        return sentence
    naming = Naming(selection)
    base = naming.one(match["base"]) if match["base"] else None
    found = naming.all(match["what"], *([base] if base else []))
    if len(found) < FEWEST or not _differ(found) or bool(match["base"]) != bool(base):
        return sentence
    rising = ordered(found, "largest first" if below else "smallest first")
    chain = [*([base] if base else []), *rising]
    told = [f"put the {upper.name} on the {lower.name}" for lower, upper in pairwise(chain)]
    return f"{sentence[: match.start()]}{', then '.join(told)}."


def _differ(things: list[Thing]) -> bool:
    """Whether every one of them is told to be of another size."""
    sizes = [thing.told_size() for thing in things]
    if None in sizes:
        sizes = [thing.measured() for thing in things]
    return None not in sizes and len(set(sizes)) == len(sizes)
