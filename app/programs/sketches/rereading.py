"""What to read a sentence as, a second time, where a word of it names nothing in the scene.

People say what is going on before they say what they want: "Recycling day at the office. Paper in
box one." Clauses that speak of nothing on the table and order nothing are left out then.
"""

import re
from collections.abc import Sequence
from itertools import pairwise

from app.programs.knowledge.classes import normal
from app.programs.knowledge.names import NUMBERS, words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.mentions import mentions
from app.programs.sketches.things import Thing

ORDERING = word_list("ordering")
"""Verbs that order something."""
_WHO = r"(?:i|you|he|she|it|we|they|somebody|someone|anyone|anybody|mum|dad|grandma|grandad|the|my|our|that|a)\b"
_SPEAKERS = (
    r"(?:(?:i|you|he|she|it|we|they|that|there|this)(?:'\w+| (?:is|are|was|were|has|have|had|can|can't|will|won't|would|may|might|should|must|"
    r"does|doesn't|do|don't|did|didn't|never|always|only|just|still|really|looks?|needs?|wants?|likes?|loves?|hates?|said|says|keeps?|gets?|goes|comes?))\b|"
    r"doesn't matter|not that)"
)
"""Who clauses speak of that order nothing: "he's only popping out"."""
_CLAUSES = re.compile(
    r"(?<=[.!?;:\u2026])\s+|\s+[\u2014\u2013-]+\s+|"
    r",\s+(?=(?:because|since|and \w+ (?:the|my|your|all)|so)\b)|"
    rf",?\s+(?=(?:(?:before|until|in case|so that) {_WHO}|(?:otherwise|so) {_SPEAKERS}))|,\s+(?={_SPEAKERS})",
    re.I,
)
_PRONOUN = re.compile(
    r"\b(?P<deed>[a-z]+)(?: up| down)? (?P<it>it|them|that)\b(?! (?:is|was|all|one)\b)", re.I
)
_BEGUN = re.compile(
    r"(?:^|[.!?;:,] |\b(?:you|please|and|then|kindly|just) )(?=(?P<deed>[a-z]+))", re.I
)


def without_asides(sentence: str, things: Sequence[Thing]) -> str | None:
    """The clauses that speak of what is there; None where that is all or nothing of them."""
    there = {normal(word) for thing in things for word in thing.words}
    there |= {thing.property("material") or "" for thing in things}
    there |= {thing.item.colour or "" for thing in things}
    there -= {*NUMBERS, *NUMBERS.values(), ""}
    clauses = [each for each in _CLAUSES.split(sentence) if each.strip()]
    kept = [each for each in clauses if _speaks_of(each, there) or _orders(each)]
    if not 0 < len(kept) < len(clauses) or _points_back(clauses, kept):
        return None
    return " ".join(kept)


def only_order(sentence: str, things: Sequence[Thing]) -> str | None:
    """The one order, with the name of the one thing that its "it" stands for.

    None where anything else is ordered, which may be of something that is not there.
    """
    found = [m for m in _PRONOUN.finditer(sentence) if m["deed"].lower() in ORDERING]
    if not found:
        return None
    order = found[-1]
    names = list(dict.fromkeys(m.name for m in mentions(sentence[: order.start()], things)))
    ordered = (m["deed"].lower() for m in _BEGUN.finditer(sentence[: order.start()]))
    if len(names) != 1 or any(each in ORDERING for each in ordered):
        return None
    end = next((m.start() for m in _CLAUSES.finditer(sentence, order.end())), len(sentence))
    return f"{sentence[order.start() : order.start('it')]}the {names[0]}{sentence[order.end('it') : end]}"


def _points_back(clauses: Sequence[str], kept: Sequence[str]) -> bool:
    """Whether "it" or "them" may stand for something that a clause left out speaks of."""
    return any(
        before not in kept and after in kept and {"it", "them"} & set(words(after))
        for before, after in pairwise(clauses)
    )


def _speaks_of(clause: str, there: set[str]) -> bool:
    return bool({normal(word.partition("'")[0]) for word in words(clause)} & there)


def _orders(clause: str) -> bool:
    said = [word for word in words(clause) if word not in ("please", "now", "then", "and", "just")]
    to_it = any(one in ORDERING and other in _POINTING for one, other in pairwise(said))
    return to_it or (bool(said) and said[0] in ORDERING)


_POINTING = frozenset(("it", "them", "this", "that", "these", "those", "one", "both"))
