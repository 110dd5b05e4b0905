"""After something was moved, "the other one" → the name of the other one."""

import re
from collections.abc import Sequence

from app.domain.planner import Turn
from app.programs.knowledge.classes import classes, normal
from app.programs.sketches.dialogue import calls_of, moved_before
from app.programs.sketches.mentions import mentions
from app.programs.sketches.naming import spoken
from app.programs.sketches.questions import ambiguous
from app.programs.sketches.things import Thing

_OTHER = re.compile(
    r"\bthe (?P<other>other(?: one)?)(?=[\s,.!?]*$|,? (?:in|into|on|onto|to|too|as well|also|please|next|now)\b)",
    re.I,
)


def other_named(sentence: str, history: Sequence[Turn], things: Sequence[Thing]) -> str:
    """The sentence with the name of the one other thing of the kind that the turn before moved.

    Raises:
        TaskDeclined: there are several others.
    """
    match = _OTHER.search(sentence)
    moved = set(moved_before(history))
    if not match or not moved or mentions(sentence[: match.start()], things):
        return sentence  # It speaks of two things itself, and this is the other one.
    others = _others(moved, _used(history), things)
    if len(others) > 1:
        raise ambiguous(match["other"], others, sentence)
    name = spoken(others)
    return f"{sentence[: match.start()]}{name}{sentence[match.end() :]}" if name else sentence


def _used(history: Sequence[Turn]) -> set[str]:
    """All names in the calls of the turns: what was moved, and where to."""
    return {
        str(argument)
        for turn in history
        for call in calls_of(turn.program)
        for argument in call.arguments
    }


def _others(moved: set[str], used: set[str], things: Sequence[Thing]) -> list[Thing]:
    """Those of the same noun; where there are none, of the same category; else of a common class."""
    before = [thing for thing in things if thing.name in moved and thing.core]
    free = [thing for thing in things if thing.name not in used and thing.core]
    for alike in (_same_noun, _same_category, _same_class):
        if found := [thing for thing in free if any(alike(thing, other) for other in before)]:
            return found
    return []


def _same_noun(one: Thing, other: Thing) -> bool:
    return normal(one.core[-1]) == normal(other.core[-1])


def _same_category(one: Thing, other: Thing) -> bool:
    told = one.item.category
    return told == other.item.category and told not in (None, "object")


def _same_class(one: Thing, other: Thing) -> bool:
    return classes().share(one.unmarked, other.unmarked)
