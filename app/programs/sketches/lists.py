"""A list of what goes where, read from its words alone: "pliers, red crate; tape, green crate; …".

With several containers, models of this size drop a line now and then, while the words tell all there
is to tell: things and containers by their names, in turn.
"""

import itertools
import re
from collections import Counter
from collections.abc import Sequence

from app.programs.knowledge.classes import normal
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.mentions import BARE, Mention
from app.programs.sketches.qualities import is_container
from app.programs.sketches.things import Thing
from app.programs.sketches.towers import Pair

FEWEST = 2
"""Containers of a list."""
_KEEPING = word_list("keeping")
"""Words of a sentence in which some things stay."""


INTO = re.compile(r"\b(?:in|into|inside|on|onto|to)(?: the| an?| my| your)? $")
"""What stands before a place that something goes to."""


def listed_pairs(sentence: str, things: Sequence[Thing]) -> list[Pair] | None:
    """Every thing that is named and the container it is named with; None where that is not plain."""
    text = " ".join(sentence.lower().split())
    if _KEEPING & set(re.findall(r"[a-z']+", text)):
        return None
    found = _named(text, things)
    holders = {each.name for each in found if INTO.search(text[: each.start])}
    holders = holders or {thing.name for thing in things if is_container(thing)}
    places = [each.name for each in found if each.name in holders]
    if len(places) < FEWEST or len({each.name for each in found}) < len(found):
        return None
    groups = [
        (held, [each.name for each in group])
        for held, group in itertools.groupby(found, lambda each: each.name in holders)
    ]
    if len(groups) % 2 or any(held and len(group) > 1 for held, group in groups):
        return None
    pairs: list[Pair] = []
    for (first_holds, first), (_, second) in zip(groups[::2], groups[1::2], strict=True):
        members, (place,) = (second, first) if first_holds else (first, second)
        pairs += [(member, place) for member in members]
    return pairs


def _named(text: str, things: Sequence[Thing]) -> list[Mention]:
    """Every naming of a thing: by its whole name, by its last word or by its first, where it alone has it."""
    heads = Counter(normal(thing.core[-1]) for thing in things if thing.core)
    firsts = Counter(thing.words[0] for thing in things if thing.words)
    whole = {" ".join(thing.words): thing.name for thing in things}
    whole |= {
        f"{thing.words[0]} one": thing.name
        for thing in things
        if len(thing.words) == 2 and firsts[thing.words[0]] == 1
    }
    last = {
        thing.words[-1]: thing.name
        for thing in things
        if thing.core and heads[normal(thing.core[-1])] == 1
    }
    spoken = last | whole
    longest = sorted(spoken, key=len, reverse=True)
    named = "|".join(
        re.escape(each) if each in whole else BARE + re.escape(each) for each in longest
    )
    return [
        Mention(match.start(), match.end(), spoken[match[0]])
        for match in re.finditer(rf"\b(?:{named})\b", text)
    ]
