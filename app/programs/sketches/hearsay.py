"""Things told by what nobody can see of them: "the mug my sister gave me" is any of the mugs."""

import re
from dataclasses import replace

from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.sketch import Phrase

_HAPPENED = "|".join(sorted(word_list("history")))
_WHOSE = (
    r"(?:that|which|who|whom|where|when|i|we|you|he|she|they|(?:my|our|your|his|her|their) \w+)"
)
_HISTORY = re.compile(
    rf"\b(?:{_HAPPENED})\b|\blast (?:night|week|month|year|time|summer|winter|\w+day)\b|"
    r"\b(?:was|were|had|been) (?:\w+ )?\w+(?:ed|ing|en|ght)\b|"
    r"\b(?:i|we|you|he|she|they) \w+ed\b|^\w+ \w+ed\b|"
    r"\b(?:likes?|loves?|prefers?|wants?)(?: the)? (?:best|most|more)\b",
    re.I,
)
_CLAUSE = re.compile(
    rf"^(?P<head>[\w' -]+?),? (?P<clause>{_WHOSE}(?:'d|'ve|'s)? .+|\w+ \w+ed\b.*|(?:\w+ )?(?:{_HAPPENED})\b.*)$",
    re.I,
)
_OF_USE = frozenset(("thing", "something", "things", "what", "whatever", "stuff"))
"""Words whose clause tells what a thing is for, rather than what became of it."""


def without_history(phrase: Phrase) -> Phrase:
    """The phrase without a clause of what became of the thing, or of who likes it."""
    match = _CLAUSE.match(phrase.text)
    if match is None or match["head"] in _OF_USE or not _HISTORY.search(match["clause"]):
        return phrase
    return replace(phrase, text=match["head"])
