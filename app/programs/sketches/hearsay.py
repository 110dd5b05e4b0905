"""Things told by what nobody can see of them: "the mug my sister gave me" is any of the mugs."""

import re
from dataclasses import replace

from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.sketch import Phrase

_HAPPENED = "|".join(sorted(word_list("history")))
_WHO = r"(?:i|we|you|he|she|they|(?:my|our|your|his|her|their) \w+)"
_WHOSE = rf"(?:that|which|who|whom|where|when|{_WHO})"
_HISTORY = re.compile(
    rf"\b(?:{_HAPPENED})\b|\blast (?:night|week|month|year|time|summer|winter|\w+day)\b|"
    r"\b(?:was|were|had|been) (?:\w+ )?\w+(?:ed|ing|en|ght)\b|"
    rf"^{_WHO}$|"  # The sketch left out the rest: "the guitar my uncle".
    r"\b(?:i|we|you|he|she|they) \w+ed\b|^\w+ \w+ed\b|"
    r"\b(?:likes?|loves?|prefers?|wants?)(?: the)? (?:best|most|more)\b",
    re.I,
)
_CLAUSE = re.compile(
    rf"^(?P<head>[\w' -]+?),? (?P<clause>{_WHOSE}(?:'d|'ve|'s)? .+|{_WHO}$|\w+ \w+ed\b.*|(?:\w+ )?(?:{_HAPPENED})\b.*)$",
    re.I,
)
_OF_USE = frozenset(("thing", "something", "things", "what", "whatever", "stuff"))
"""Words whose clause tells what a thing is for, rather than what became of it."""

_LINKS = frozenset(("to", "on", "at", "of", "in", "for", "from", "with", "by", "near"))
"""No clause begins behind one of them: "the tray to your right"."""


def without_history(phrase: Phrase) -> Phrase:
    """The phrase without a clause of what became of the thing, or of who likes it."""
    match = _CLAUSE.match(phrase.text)
    if match is None or not _HISTORY.search(match["clause"]):
        return phrase
    head = match["head"].split()
    if head[0] in _OF_USE or head[-1] in _LINKS:
        return phrase
    return replace(phrase, text=match["head"])
