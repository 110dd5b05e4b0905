"""What "everything" means to who opens and shuts: what the scene tells to be the other way."""

from collections.abc import Sequence

from app.programs.knowledge.solids import is_solid
from app.programs.sketches.qualities import is_container
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import Thing

BEFORE = {"open": ("closed",), "close": ("open", "opened")}
"""Verbs, and what their things are before."""


def openable(found: Sequence[Thing], action: str, selection: Selection) -> list[Thing]:
    """Those that are still to be opened or shut; where nothing is told of any, those with an inside."""
    told = {rel.arguments[0] for rel in selection.facts if rel.name in BEFORE[action]}
    if kept := [each for each in found if each.name in told]:
        return kept
    hollow = [each for each in found if not is_solid(each.name)]
    return [each for each in hollow if is_container(each)] or hollow or list(found)
