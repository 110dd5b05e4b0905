"""Things that the sentence says "not" of, whatever else it says: "everything, and not the lamp"."""

import re
from collections.abc import Sequence

from app.programs.sketches.description import Description
from app.programs.sketches.mentions import mentions
from app.programs.sketches.things import Thing

_NOT = re.compile(
    r"\b(?:not|nor|except(?: for)?|apart from|excluding|minus)(?: (?:the|my|your|our|that|this|any))? $"
)


def denied(things: Sequence[Thing], sentence: str) -> set[str]:
    """The names of what stands behind "not"; nothing of what the sentence names besides."""
    text = " ".join(sentence.lower().split())
    whole = {" ".join(thing.words) for thing in things}
    found = [each for each in mentions(sentence, things) if text[each.start : each.end] in whole]
    out = {each.name for each in found if _NOT.search(text[: each.start])}
    return out - {each.name for each in found if not _NOT.search(text[: each.start])}


def undenied(
    found: list[Thing], described: Description, things: Sequence[Thing], sentence: str
) -> list[Thing]:
    """Of a set that no word tells of, only "everything", what is not denied."""
    out = denied(things, sentence) if described.vague else set[str]()
    return [thing for thing in found if thing.name not in out] or found
