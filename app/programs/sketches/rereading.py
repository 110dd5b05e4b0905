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
from app.programs.sketches.things import Thing

ORDERING = word_list("ordering")
"""Verbs that order something."""
_CLAUSES = re.compile(
    r"(?<=[.!?;:\u2026])\s+|\s+[\u2014\u2013-]+\s+|"
    r",\s+(?=(?:it's|it is|they're|because|since|and \w+ (?:the|my|your|all)|so)\b)"
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
