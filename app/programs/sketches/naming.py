"""Words of a sentence → the things they surely mean, and things → the names to say them by."""

import re
from collections.abc import Sequence

from app.domain.errors import TaskDeclined
from app.programs.knowledge.names import is_mark
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing


class Naming:
    """Looks words up among the things of one scene, before a model has read the sentence."""

    def __init__(self, selection: Selection) -> None:
        self._selection = selection

    def one(self, text: str) -> Thing | None:
        """The thing; None where none or several are called so."""
        try:
            return self._selection.one(Phrase(text=text)).things[0]
        except TaskDeclined:
            return None

    def all(self, text: str, *without: Thing) -> list[Thing]:
        """All things that are called so."""
        phrase, names = Phrase(text=text, quantity="all"), {thing.name for thing in without}
        if not self._selection.possible(phrase, names):
            return []
        return list(self._selection.all(phrase, names).things)


def spoken(things: Sequence[Thing]) -> str:
    """Their names as one says them; nothing where one of them cannot be said."""
    if not all(re.fullmatch(r"[\w' -]{1,60}", thing.name) for thing in things):
        return ""
    return " and ".join(
        thing.name if is_mark(thing.words[-1]) else f"the {thing.name}" for thing in things
    )
