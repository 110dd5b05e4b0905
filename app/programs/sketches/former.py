"""Two things that a sentence names, and then calls "the first" and "the other" → their names again."""

import re
from collections.abc import Sequence

from app.programs.sketches.mentions import mentions
from app.programs.sketches.things import Thing

_END = r"(?=\s*[,;:.!?]|\s*$| (?:in|into|inside|on|onto|to|back|safe|safely|goes|belongs|should|must|can|needs|and|with|over|away)\b)"
_FIRST = re.compile(rf"\bthe (?:first|former)(?: one)?{_END}", re.I)
_OTHER = re.compile(rf"\bthe (?:other|second|latter|last)(?: one)?{_END}", re.I)
_KEPT = re.compile(
    r"\b(?:keep|leave|stand|save) (?P<what>the [\w' -]+?) (?:safe|safely|nicely|well away|up high) "
    r"(?P<where>(?:in|on|inside) (?:the|my|our|that) )",
    re.I,
)
"""Keep the owl safe on the shelf, where it is not yet."""


def named_again(sentence: str, things: Sequence[Thing]) -> str:
    """The sentence with the names of the two things it named before it tells them by their order."""
    text = " ".join(sentence.split())
    first, other = _FIRST.search(text), _OTHER.search(text)
    if first is None or other is None or other.start() < first.start():
        return sentence
    named = [each.name for each in mentions(text[: first.start()], things)]
    if len(named) != 2 or named[0] == named[1]:
        return sentence
    told = _OTHER.sub(f"the {named[1]}", _FIRST.sub(f"the {named[0]}", text, 1), 1)
    return _KEPT.sub(r"put \g<what> \g<where>", told)
