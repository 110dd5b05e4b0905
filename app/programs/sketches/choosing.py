"""Of several things that fit words for one thing: the likeliest, more than one where all are alike."""

from collections.abc import Collection, Sequence

from app.programs.knowledge.classes import UNREAL
from app.programs.knowledge.names import is_mark, plain, words
from app.programs.sketches.matching import COUNTS, HEAD
from app.programs.sketches.phrase import describe_phrase
from app.programs.sketches.qualities import Fits, is_container
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing

_LEFT_OVER = frozenset(("other", "last", "remaining", "leftover"))
"""Words for the one that nothing was said of yet."""


def likeliest(
    found: Fits,
    phrase: Phrase,
    things: Sequence[Thing],
    *,
    sentence: str,
    spoken: Collection[str],
    holds: bool,
) -> tuple[list[Thing], float]:
    """Those that fit best, and how well; ``spoken`` are the names that the sentence told before.

    ``holds``: it is what something is put into.
    """
    best = max(score for _, score in found)
    if holds and best < HEAD - 0.02:
        found = [p for p in found if is_container(p[0])] or _named_after(phrase, things) or found
        best = max(score for _, score in found)
    equal = [thing for thing, score in found if score >= best - 0.015]
    if len(equal) > 1 and holds:
        equal = [thing for thing in equal if is_container(thing)] or equal
    equal = _twins(equal, phrase, found, best)
    if len(equal) > 1 and _LEFT_OVER & set(words(sentence)):
        equal = [t for t in equal if t.name not in spoken] or equal
    if len(equal) > 1 and not UNREAL & set(words(phrase.text)):
        equal = [t for t in equal if not UNREAL & set(t.words)] or equal
    if len(equal) > 1:
        whole = [t for t in equal if len(t.words) > 1 and plain(t.name) in plain(sentence)]
        equal = whole if len(whole) == 1 else equal
    return equal, best


def _named_after(phrase: Phrase, things: Sequence[Thing]) -> Fits:
    """The one container that has the words in its name: "with the paper" is the paper bin."""
    said = set(describe_phrase(phrase).core)
    named = [t for t in things if said <= set(t.words) and is_container(t)]
    return [(named[0], COUNTS)] if said and len(named) == 1 else []


def _twins(equal: list[Thing], phrase: Phrase, found: Fits, best: float) -> list[Thing]:
    """With the look-alikes of the one called exactly so: "cup" where there is a "cup 2"."""
    if len(equal) != 1 or not best > 0.97 or is_mark(equal[0].words[-1]):
        return equal
    if describe_phrase(phrase).side or describe_phrase(phrase).ordinal:
        return equal
    return [
        thing
        for thing, _ in found
        if thing is equal[0]
        or (
            len(thing.words) == len(equal[0].words) + 1
            and thing.words[:-1] == equal[0].words
            and thing.words[-1].isdigit()
            and thing.name.lower()
            == f"{equal[0].name.lower()}{thing.name[len(equal[0].name)]}{thing.words[-1]}"
        )
    ]
