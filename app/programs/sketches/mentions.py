"""Where a sentence names the things of a scene, by their whole names or by what they alone are called."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from app.programs.knowledge.membership import CUTS
from app.programs.sketches.things import Thing

BARE = r"(?:(?<=the )|(?<=\ba )|(?<=an )|(?<=my )|(?<=, )|(?<=; )|(?<=: )|(?<=\. )|^)"
"""What stands before a noun that is said without the rest of its name: "can" is more often a verb."""
_LINKS = frozenset(("of", "with", "for", "in", "and", "the"))


@dataclass(frozen=True, slots=True)
class Mention:
    """Where a sentence names a thing."""

    start: int
    end: int
    name: str


def mentions(sentence: str, things: Sequence[Thing]) -> list[Mention]:
    """Every naming of a thing in the sentence, by its whole name or by the word it alone has."""
    spoken: dict[str, str] = {" ".join(thing.words): thing.name for thing in things}
    alike = [
        t for t in things if t.core and sum(t.core[-1] == o.core[-1] for o in things if o.core) > 1
    ]
    spoken |= _by_what_is_before(alike)
    short = {word: name for word, name in _by_one_word(things).items() if word not in spoken}
    longest = sorted({**spoken, **short}, key=len, reverse=True)
    named = "|".join(
        re.escape(each) if each in spoken else BARE + re.escape(each) for each in longest
    )
    spoken |= short
    pattern = re.compile(rf"\b(?:{named})\b(?: (?:one|block|cube|brick)\b)?", re.I)
    lowered = " ".join(sentence.lower().split())
    return [
        Mention(match.start(), match.end(), spoken[_known(match[0], spoken)])
        for match in pattern.finditer(lowered)
    ]


def _by_what_is_before(alike: Sequence[Thing]) -> dict[str, str]:
    """What things of one noun are told apart by: the mountain bike one, of ``mountain bike tyre``."""
    before = [(" ".join(thing.words[:-1]), thing) for thing in alike if len(thing.words) > 1]
    said = [word for word, _ in before]
    return {
        word: thing.name
        for word, thing in before
        if said.count(word) == 1 and (len(thing.words) == 2 or thing.words[-2] not in _LINKS)
    }


def _by_one_word(things: Sequence[Thing]) -> dict[str, str]:
    """The patty of a ``beef patty``, the cheese of a ``cheese slice``, where nothing else is called so."""
    found: dict[str, str] = {}
    for thing in things:
        if len(thing.core) == 1 and "of" in thing.words[1:-1]:
            found |= _alone(thing.core[0], thing, things)  # the ham, of a slice of ham
        if len(thing.core) < 2 or thing.core != thing.words:
            continue
        word = thing.core[0] if thing.core[-1] in CUTS and len(thing.core) == 2 else thing.core[-1]
        found |= _alone(word, thing, things)
    return found


def _alone(word: str, thing: Thing, things: Sequence[Thing]) -> dict[str, str]:
    shared = sum(word in other.words for other in things) > 1
    return {} if shared or len(word) < 3 else {word: thing.name}


def _known(text: str, spoken: dict[str, str]) -> str:
    return text if text in spoken else text.rpartition(" ")[0]
