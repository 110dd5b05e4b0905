"""A phrase that is less, or more, than the name that the sentence says → the name."""

import re
from collections.abc import Sequence
from dataclasses import replace

from app.programs.knowledge.classes import normal
from app.programs.knowledge.names import plain, words
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing

_MODALS = frozenset(("can", "could", "will", "would", "should", "must", "may", "goes", "go", "is"))


def whole_name(phrase: Phrase, sentence: str, things: Sequence[Thing]) -> Phrase:
    """The whole name where the phrase stands only as a part of it: "desk" of the desk tidy."""
    phrase = without_verb(phrase, things)
    said = plain(sentence)
    text = plain(phrase.text)
    longer = [
        name
        for thing in things
        if (name := plain(thing.name)) in said
        and (name.startswith(f"{text} ") or name.endswith(f" {text}"))
    ]
    alone = len(longer) == 1 and text not in said.replace(longer[0], "")
    if alone:
        return replace(phrase, text=longer[0])
    return _whole_kind(phrase, said, things) if phrase.quantity == "all" else phrase


def _whole_kind(phrase: Phrase, said: str, things: Sequence[Thing]) -> Phrase:
    """The same of several that are called alike: "flowers" of "every flower pot"."""
    text = normal(phrase.text)
    longer = {
        thing.unmarked
        for thing in things
        if thing.unmarked.startswith(f"{text} ")
        and re.search(rf"\b{re.escape(thing.unmarked)}s?\b", said)
    }
    if len(longer) != 1:
        return phrase
    kind = longer.pop()
    elsewhere = re.search(
        rf"\b{re.escape(text)}s?\b", re.sub(rf"\b{re.escape(kind)}s?\b", "", said)
    )
    return phrase if elsewhere else replace(phrase, text=kind)


def without_verb(phrase: Phrase, things: Sequence[Thing]) -> Phrase:
    """Without the verb that follows a name in the sentence: "the vase can"."""
    found = words(phrase.text)
    if len(found) < 2 or found[-1] not in _MODALS:
        return phrase
    if any(found[-1] in thing.words for thing in things):
        return phrase
    return replace(phrase, text=" ".join(found[:-1]))


def bare(text: str) -> str:
    """Without the article."""
    found = words(text)
    return text if not found else re.sub(r"^(?:the|a|an|my|your)\s+", "", text, flags=re.I)
