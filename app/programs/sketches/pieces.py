"""A sentence with several places, cut into pieces of one place each.

A small model that reads many lines at once leaves one out now and then: a container that the sentence
names and the program does not use tells so. Read one by one, the pieces are easy.
"""

import re
from collections.abc import Collection, Sequence
from itertools import pairwise

from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.lists import INTO
from app.programs.sketches.mentions import Mention, mentions
from app.programs.sketches.qualities import is_container
from app.programs.sketches.things import Thing

_CUT = re.compile(r"[,;.!](?=\s)|\s(?=(?:and|but|while|whereas) )")
_KEEPING = word_list("keeping")
_POINTING = frozenset(("it", "them", "they", "there", "same", "too", "ditto", "both", "ones"))
"""Words that a piece alone does not explain."""
FEWEST_WORDS = 3
"""Of a piece: less says not enough by itself."""


def named_places(sentence: str, things: Sequence[Thing]) -> list[Mention]:
    """Where the sentence names containers in full, or what something goes onto, each once."""
    text = " ".join(sentence.lower().split())
    holders = {thing.name for thing in things if is_container(thing)}
    found = [
        each
        for each in mentions(sentence, things)
        if each.name in holders or INTO.search(text[: each.start])
    ]
    return list({each.name: each for each in reversed(found)}.values())[::-1]


def pieces(sentence: str, things: Sequence[Thing], used: Collection[str]) -> list[str] | None:
    """The pieces; None where every place is used, or the sentence hangs together."""
    places = named_places(sentence, things)
    if len(places) < 2 or {each.name for each in places} <= set(used):
        return None
    text = " ".join(sentence.lower().split())
    if (_KEEPING | _POINTING) & set(re.findall(r"[a-z']+", text)):
        return None
    cuts: list[int] = []
    for one, other in pairwise(places):
        between = [match.start() for match in _CUT.finditer(text, one.end, other.start)]
        if not between:
            return None
        cuts.append(between[0] if INTO.search(text[: one.start]) else between[-1])
    ends = [0, *cuts, len(text)]
    found = [text[a:b].strip(" ,;.!") for a, b in pairwise(ends)]
    found = [re.sub(r"^(?:and|but|while|whereas) ", "", each) for each in found]
    return found if all(len(each.split()) >= FEWEST_WORDS for each in found) else None
