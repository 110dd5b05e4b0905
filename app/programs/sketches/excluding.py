"""What words for an exception take out of a set: "but not the kiwi", "that is not red"."""

import re
from collections.abc import Callable, Collection
from dataclasses import replace

from app.programs.knowledge.classes import VAGUE, normal
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.description import Description
from app.programs.sketches.matching import SETS, UNMARKED
from app.programs.sketches.qualities import Fits
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing

Fitting = Callable[[Phrase, Collection[str]], Fits]
"""The things of the scene that fit a phrase, without those of the names."""


_EXCEPTION = word_list("exception")
_NO_EXCEPTION = re.compile(
    r"\bno (?:need|hurry|rush|matter|problem|worries|doubt)\b|\bnot (?:yet|far|long)\b", re.I
)
_CLAUSE = re.compile(
    r"\b(?:but|except(?: for)?|unless|not|skip|skipping|without|omit|ignore|excluding|leave(?: out)?|apart from|other than)"
    r"(?: not| skip| leave(?: out)?| for)? (?:what(?:ever)?|anything|everything|(?:the )?(?:ones|things|stuff)|those|all)"
    r"(?: that| which)?(?P<clause> [^,.;:!?()]+)",
    re.I,
)
"""What is left out, told by a clause: "but skip whatever goes on my feet"."""
_POSSESSED = re.compile(r"^ (?:i|you|we|one|people|they)\b", re.I)


def heard(phrase: Phrase, sentence: str, fitting: Fitting) -> Phrase:
    """The phrase with what the sentence leaves out, where the sketch made something else of it.

    A word said in passing, "(kept cold)", is no exception where nothing of the sentence makes one;
    of a clause, sketches keep no more than "things".
    """
    if not phrase.but:
        return phrase
    spoken = set(words(_NO_EXCEPTION.sub("", sentence)))
    if not spoken & _EXCEPTION and not any(each.endswith("n't") for each in spoken):
        return replace(phrase, but=tuple(each for each in phrase.but if _names(each, fitting)))
    clause = _CLAUSE.search(sentence)
    if clause is None:
        return phrase
    return replace(phrase, but=tuple(_told(each, clause["clause"]) for each in phrase.but))


def _names(text: str, fitting: Fitting) -> bool:
    """Whether the words surely mean a thing that is there."""
    return any(score >= SETS for _, score in fitting(Phrase(text=text, quantity="all"), ()))


def _told(left_out: str, clause: str) -> str:
    """The words of the clause for words that say nothing by themselves."""
    found = set(words(left_out))
    if found - VAGUE - _EXCEPTION - {"that", "which", "what", "whatever", "you", "can"}:
        return left_out
    return f"things{clause}" if _POSSESSED.match(clause) else f"what{clause}"


def without_excluded(kept: Fits, excluded: Description, fitting: Fitting) -> Fits:
    """Those that the words for the exception do not fit."""
    single = normal(excluded.text) == " ".join(words(excluded.text))
    ranked = excluded.side or excluded.superlative or excluded.ordinal
    phrase = Phrase(text=excluded.text, quantity="one" if single and ranked else "all")
    found = fitting(phrase, ())
    out = {thing.name for thing, _ in found}
    if not excluded.vague and max((score for _, score in found), default=0.0) >= UNMARKED:
        # Its name: with the lamp, no candle stays, which is a lamp of a kind.
        out = {thing.name for thing, score in found if score >= UNMARKED}
    elif not excluded.vague:
        named = {t.name for t, _ in found if len(excluded.core) > 1 and _in_name(excluded, t)}
        out = named or {thing.name for thing, score in found if score >= SETS} or out
    if not out:
        use = Phrase(text=f"things you can {excluded.text}", quantity="all")
        out = {thing.name for thing, _ in fitting(use, ())}
    if not out & {thing.name for thing, _ in kept}:
        out = {t.name for t, _ in kept if _in_name(excluded, t)}
    left = [(thing, score) for thing, score in kept if thing.name not in out]
    if left or excluded.vague:
        return left
    # Nobody asks for power tools without tools: they mean others.
    return [pair for pair in kept if not _in_name(excluded, pair[0])]


def _in_name(described: Description, thing: Thing) -> bool:
    """Whether all of the words stand in the name: the dog food, of a ``dog food tin``."""
    said = {normal(each) for each in described.core}
    return bool(said) and said <= {normal(each) for each in thing.words}
