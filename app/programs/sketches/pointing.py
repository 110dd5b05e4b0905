"""Things told by where they stand, by their names: "the mug between the plate and the bowl".

Sketches have no word for "between", and a model of this size takes what is closest to the can for
what is closest to the robot. Where the scene tells which thing is meant, the sentence that the model
reads has its name; else it stays as it was.
"""

import re
from collections.abc import Callable, Sequence

from app.programs.knowledge.names import NUMBERS
from app.programs.sketches.lists import INTO
from app.programs.sketches.naming import Naming, spoken
from app.programs.sketches.qualities import distance, is_placed, stands
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import Thing

_NUMBER = rf"(?P<number>{'|'.join(list(NUMBERS)[1:])}|[2-9])"
_THE = r"\b(?:the|that|this|my|your|whichever|an?) "
_WHAT = r"(?P<what>(?:[\w'-]+ ){0,2}?[\w'-]+)"
_LIES = r"(?:,? (?:that|which)(?:'s| is| are| lies| stands| sits))?(?: standing| sitting| lying| placed| located)?"
_GOES = r"(?:in|into|inside|on|onto|to|goes?|belongs?|should|must|can|needs?|gets?|has|is|and|up|please|over|for|from)\b"
_END = rf"(?=\s*(?:[,.;:!?)]|$)|\s+{_GOES})"
_BETWEEN = re.compile(
    rf"{_THE}{_WHAT}{_LIES}(?: right| directly| exactly)?(?: in)? between (?:the |my )?"
    rf"(?P<one>[\w' -]+?) and (?:the |my )?(?P<other>[\w' -]+?){_END}",
    re.I,
)
_NEAR = re.compile(
    rf"{_THE}{_WHAT}{_LIES}(?: right| directly| just)? "
    r"(?:(?P<near>nearest(?: to)?|closest(?: to)?|next to|close to|near(?: to)?|beside|by)|"
    r"(?P<far>(?:farthest|furthest|far)(?: away)? from)) "
    rf"(?:the |my |that )?(?P<one>[\w' -]+?){_END}",
    re.I,
)
_OUTER = re.compile(
    r"\bthe (?:two )?(?:outer|outermost)(?: two)? (?P<what>\w+)|"
    r"\bthe (?:two )?(?P<ends>\w+) (?:at|on) (?:the|both|either)(?: two| far| very| outer)? (?:ends?|sides)\b(?! of)",
    re.I,
)
_SEVERAL = re.compile(
    rf"\bthe (?:{_NUMBER} (?P<side>left|right)(?:most)? (?P<what>\w+)|"
    rf"(?P<side2>left|right)(?:most)? {_NUMBER.replace('number', 'number2')} (?P<what2>\w+)|"
    rf"{_NUMBER.replace('number', 'number3')} (?P<what3>\w+){_LIES} "
    r"(?:on|to) the (?:far |very )?(?P<side3>left|right)(?:[- ]hand)?(?: side| end)?)\b",
    re.I,
)
_FOLLOWED = re.compile(rf"[,]? {_GOES}", re.I)
SAME_DISTANCE = 1e-6
"""Up to which difference of squared distances two things are as near [m²]."""


def pointed(sentence: str, selection: Selection) -> str:
    """The sentence with the names of things in place of words for where they stand."""
    pointing = _Pointing(selection)
    told: Sequence[tuple[re.Pattern[str], Callable[[re.Match[str]], list[Thing]]]] = (
        (_BETWEEN, pointing.between),
        (_NEAR, pointing.near),
        (_OUTER, pointing.outer),
        (_SEVERAL, pointing.at_side),
    )
    for pattern, find in told:
        for match in reversed(list(pattern.finditer(sentence))):
            if names := spoken(find(match)):
                sentence = sentence[: match.start()] + names + sentence[match.end() :]
    return sentence


class _Pointing:
    """Finds what is meant among the things of one scene; nothing where that is not certain."""

    def __init__(self, selection: Selection) -> None:
        self._naming = Naming(selection)

    def between(self, match: re.Match[str]) -> list[Thing]:
        one, other = (self._naming.one(match[each]) for each in ("one", "other"))
        if not one or not other or one is other or not _tells_thing(match):
            return []
        found = self._naming.all(match["what"], one, other)
        if len(found) < 2:
            return found
        (ax, ay, _), (bx, by, _) = stands(one), stands(other)
        length = (bx - ax) ** 2 + (by - ay) ** 2
        if not (is_placed(one) and is_placed(other) and length):
            return []

        def along(thing: Thing) -> float:
            x, y, _ = stands(thing)
            return ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length

        inner = [thing for thing in found if is_placed(thing) and 0.02 < along(thing) < 0.98]
        middle = ((ax + bx) / 2, (ay + by) / 2, 0.0)
        return _least(inner, lambda thing: distance(thing, middle))

    def near(self, match: re.Match[str]) -> list[Thing]:
        anchor = self._naming.one(match["one"])
        if not anchor or not _tells_thing(match):
            return []
        found = self._naming.all(match["what"], anchor)
        if len(found) < 2:
            return []
        if not is_placed(anchor) or not all(map(is_placed, found)):
            return []
        sign = 1 if match["near"] else -1
        return _least(found, lambda thing: sign * distance(thing, stands(anchor)))

    def outer(self, match: re.Match[str]) -> list[Thing]:
        row = self._row(match["what"] or match["ends"])
        return [row[0], row[-1]] if len(row) > 2 and _apart(row, 1) and _apart(row, -1) else []

    def at_side(self, match: re.Match[str]) -> list[Thing]:
        said = {
            key[:-1] if key[-1].isdigit() else key: v for key, v in match.groupdict().items() if v
        }
        row = self._row(said["what"])
        count = int(NUMBERS.get(said["number"].lower(), said["number"]))
        if said["side"].lower() == "right":
            count = -count
        if abs(count) >= len(row) or not _apart(row, count):
            return []
        return row[:count] if count > 0 else row[count:]

    def _row(self, text: str) -> list[Thing]:
        """From left to right; none where it is not known where one of them stands."""
        found = self._naming.all(text)
        return sorted(found, key=lambda t: -stands(t)[1]) if all(map(is_placed, found)) else []


def _apart(row: Sequence[Thing], place: int) -> bool:
    """Whether the row can be cut there: what stands at either side of the cut stands apart."""
    return stands(row[place - 1])[1] - stands(row[place])[1] > SAME_DISTANCE


def _tells_thing(match: re.Match[str]) -> bool:
    """Whether the words tell which thing is meant, and not where it is to go."""
    before, after = match.string[: match.start("what")], match.string[match.end() :]
    return bool(INTO.search(before) or _FOLLOWED.match(after))


def _least(found: Sequence[Thing], key: Callable[[Thing], float]) -> list[Thing]:
    ordered = sorted(found, key=key)
    if len(ordered) > 1 and key(ordered[1]) - key(ordered[0]) < SAME_DISTANCE:
        return []
    return ordered[:1]
