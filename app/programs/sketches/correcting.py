"""Corrections: "put the lemon in the box, no wait, the pear" → "put the pear in the box".

What is put right is what plays the same part: a thing to put for what is put, a container or words
with "in" for where it goes. The same holds for a sentence that corrects the one before it.
"""

import re
from collections.abc import Sequence

from app.programs.sketches.naming import Naming
from app.programs.sketches.qualities import is_container
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import Thing

_MARK = (
    r"(?:(?:no+|nope|oh|oops|ah|er+m?|uh|wait|sorry|actually|pardon|hold on|scratch that|my mistake|or rather|"
    r"rather|correction|i (?:mean|meant)(?: to say)?|make (?:that|it)|that is|not that(?: one)?)\b[\s,.!;\u2026\u2014-]*)"
)
_PLACING = r"in|into|inside|on|onto|to"
_NOUN = r"(?:(?:the|my|your|a|an|that|this)\s+[\w' -]+?|it|them|everything)"
_INSTEAD = (
    rf"(?:not {_NOUN}\s*,?\s*(?:but )?)?(?P<after>(?:(?P<link>{_PLACING})\s+)?(?P<what>{_NOUN}))"
    r"(?:\s+instead|\s+please)*[\s.!]*$"
)
_INSIDE = re.compile(
    rf"^(?P<before>.+?)[\s,.;\u2026\u2014-]*[,.;\u2026\u2014-]\s*{_MARK}+{_INSTEAD}", re.I
)
_ALONE = re.compile(rf"^\s*{_MARK}+{_INSTEAD}", re.I)
_MOVE = re.compile(
    rf"^(?P<verb>.*?\b(?<!\bnot ))(?P<thing>{_NOUN})(?:\s+(?P<link>{_PLACING})\s+(?P<place>{_NOUN}))?"
    r"(?P<tail>\s+(?:please|too|as well|now))?[\s.!]*$",
    re.I,
)


def correction(sentence: str, before: str, things: Sequence[Thing]) -> str | None:
    """The sentence before as this one puts it right; None where this one says something else."""
    match = _ALONE.match(sentence)
    if match is None:
        return None
    joined = f"{before.rstrip(' .!')}, no, {match['after']}"
    right = corrected(joined, things)
    naming = Naming(Selection(things, frozenset(), sentence))
    return right if right != joined or naming.all(_bare(match["what"])) else None


def corrected(sentence: str, things: Sequence[Thing]) -> str:
    """The sentence with its own correction made; as it is where it has none, or that is not plain."""
    match = _INSIDE.match(sentence)
    move = _MOVE.match(match["before"]) if match else None
    if not match or not move:
        return sentence
    naming = Naming(Selection(things, frozenset(), sentence))

    def named(text: str | None) -> Thing | None:
        return naming.one(_bare(text)) if text else None

    thing, link, place = move["thing"], move["link"], move["place"]
    instead = named(match["what"])
    if match["link"]:
        link, place = match["link"], match["what"]
    elif instead is None:
        return sentence
    elif place is None or (not is_container(instead) and _holds(named(place))):
        thing = match["what"]
    elif is_container(instead) and not _holds(named(thing)):
        place = match["what"]
    else:
        return sentence
    where = f" {link} {place}" if place else ""
    return f"{move['verb']}{thing}{where}{move['tail'] or ''}"


def _holds(thing: Thing | None) -> bool:
    return thing is not None and is_container(thing)


def _bare(text: str) -> str:
    """Without the article."""
    return re.sub(r"^\w+\s+", "", text)
