"""Questions back: what is said where nothing fits, or several things do."""

import re
from collections.abc import Sequence

from app.domain.errors import TaskDeclined
from app.programs.sketches.things import Thing, listed

MOST_CHOICES = 6


def absent(text: str, things: Sequence[Thing]) -> TaskDeclined:
    """Nothing in the scene fits the words."""
    names = listed([thing.name for thing in things]) or "nothing"
    return TaskDeclined(
        f"there is no {text} here, only {names}",
        kind="absent",
        question=f"What do you mean by {text!r}?",
    )


def ambiguous(text: str, equal: Sequence[Thing], asked: str) -> TaskDeclined:
    """Several objects fit the words of the sentence ``asked`` equally well."""
    names = [thing.name for thing in equal]
    return TaskDeclined(
        f"{text!r} could be {listed(names, 'or')}",
        kind="ambiguous",
        question=f"Which {text} do you mean: {listed(names, 'or')}?",
        choices=tuple(_said_with(text, name, asked) for name in names[:MOST_CHOICES]),
    )


def _said_with(text: str, name: str, asked: str) -> str:
    """The sentence with the object's own name in place of the words."""
    spoken = r"\s+".join(map(re.escape, text.split()))
    clear, times = re.subn(rf"\b{spoken}\b", lambda _: name, asked, count=1, flags=re.I)
    return clear if times else f"{asked} ({text}: {name})"
