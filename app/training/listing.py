"""Several things as one phrase: ``the knife, the fork and the spoon``."""

from collections.abc import Sequence
from random import Random

from app.training.said import Said

ENDINGS = (" and ", " and ", " and ", " as well as ", " plus ", " & ")
"""What stands before the second of two."""
LONGER = (" and ", " and ", " and ", ", and ", " as well as ", " plus ", " & ", ", ")
"""And before the last of more."""


def listed(rng: Random, texts: Sequence[str]) -> str:
    """``a, b and c``, and other ways."""
    if len(texts) == 1:
        return texts[0]
    last = rng.choice(LONGER)
    if len(texts) == 2:
        last = rng.choice(ENDINGS)
    return ", ".join(texts[:-1]) + last + texts[-1]


def joined(items: Sequence[Said], text: str) -> Said:
    """Several things by the text that says them all."""
    found = tuple(argument for each in items for argument in each.arguments)
    words = items[0].words if len(items) == 1 else f"[{', '.join(each.words for each in items)}]"
    nor = f"not {text}"
    if len(items) == 2:
        nor = f"neither {items[0].text} nor {items[1].text}"
    return Said(text, found, words, plural=len(items) > 1, forms={"nor": nor})


def enumerated(rng: Random, items: Sequence[Said]) -> Said:
    """Several things, each by its own text."""
    return joined(items, listed(rng, [each.text for each in items]))
