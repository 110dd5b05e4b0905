"""What is shared out among containers: "share the apples evenly between the basket and the crate".

Who gets what is a matter of counting, which a model of this size does badly and the scene settles:
the sentence that it reads has the shares by their names.
"""

import re
from collections.abc import Sequence

from app.programs.knowledge.names import NUMBERS
from app.programs.sketches.naming import Naming, spoken
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import Thing

_EVENLY = r"(?: evenly| equally| fairly| out| up| in equal (?:parts|shares|numbers))*"
_WHAT = r"(?:all )?(?:of )?(?:the |my |our |these |those )?(?P<what>[\w' -]+?)"
_AMONG = r"(?P<places>(?:the|both|all|my|a|an) [\w' ,-]+?)"
_COUNT = rf"(?P<count>an?|exactly one|{'|'.join(NUMBERS)}|[1-9])"
_END = r"(?=\s*(?:[.;:!?]|$)|, (?:please|so)\b| please\b)"
_SHARED = re.compile(
    rf"\b(?:share|divide|split|distribute|spread|deal|dole|hand)\b{_EVENLY} {_WHAT}{_EVENLY} "
    rf"(?:between|among|amongst|over|across|into|onto|to) {_AMONG}{_EVENLY}{_END}",
    re.I,
)
_EACH = tuple(
    re.compile(pattern + _END, re.I)
    for pattern in (
        rf"(?<![\w'] ){_AMONG} (?:should |must |shall |will )?(?:each|both) "
        rf"(?:gets?|receives?|needs?|wants?|takes?|holds?|have|has) {_COUNT} (?P<what>[\w' -]+?)",
        rf"\bgive {_AMONG} {_COUNT} (?P<what>[\w' -]+?)(?: each| apiece)",
        rf"\b(?:put |place |drop |lay )?{_COUNT} (?P<what>[\w' -]+?) (?:each|apiece) "
        rf"(?:for|to|in|into|on|onto) {_AMONG}",
        rf"\b(?:put |place |drop |lay )?{_COUNT} (?P<what>[\w' -]+?) (?:in|into|on|onto|to|for) each of {_AMONG}",
    )
)


def allotted(sentence: str, selection: Selection) -> str:
    """The sentence with each share and the place it goes to; as it is where it does not come out."""
    naming = Naming(selection)
    for pattern in (_SHARED, *_EACH):
        match = pattern.search(sentence)
        if match and (told := _shares(match, naming)):
            return f"{sentence[: match.start()]}{told}{sentence[match.end() :]}"
    return sentence


def _shares(match: re.Match[str], naming: Naming) -> str:
    places = _places(match["places"], naming)
    things = naming.all(match["what"], *places)
    if len(places) < 2 or len(things) < len(places):
        return ""
    said = match.groupdict().get("count")
    shares = _counted(things, places, said) if said else _even(things, places)
    if not shares or not all(spoken([*share, place]) for share, place in shares):
        return ""
    return "put " + " and ".join(f"{spoken(share)} in {spoken([place])}" for share, place in shares)


Share = tuple[Sequence[Thing], Thing]


def _counted(things: Sequence[Thing], places: Sequence[Thing], said: str) -> list[Share]:
    """So many for each; none where they do not suffice."""
    last = said.lower().split()[-1]
    count = 1 if last in ("a", "an") else int(NUMBERS.get(last, last))
    if len(things) < count * len(places):
        return []
    return [(things[i * count : (i + 1) * count], place) for i, place in enumerate(places)]


def _even(things: Sequence[Thing], places: Sequence[Thing]) -> list[Share]:
    """As many for each, or one more for the first of them."""
    return [(things[i :: len(places)], place) for i, place in enumerate(places)]


def _places(text: str, naming: Naming) -> list[Thing]:
    """Each of "the basket and the crate", or all of "the two bowls"."""
    parts = [each for each in re.split(r",? and |, ", text) if each]
    if len(parts) > 1:
        found = [naming.one(re.sub(r"^(?:the|my|an?) ", "", each)) for each in parts]
        return [each for each in found if each] if all(found) else []
    numbers = "|".join(NUMBERS)
    return naming.all(re.sub(rf"^(?:the |my |both |all |of |{numbers} )+", "", text, flags=re.I))
