"""Class names written in one word → the words they are made of: ``washingmachine``."""

from collections.abc import Collection
from functools import cache

from app.programs.knowledge.classes import classes, normal
from app.programs.knowledge.wordnet import nouns

_PIECES = frozenset(
    (
        "tv",
        "cpu",
        "living",
        "dining",
        "washing",
        "cutting",
        "whipped",
        "frying",
        "cooking",
        "childrens",
        "creamy",
    )
)
"""First parts that are no nouns, or not nouns that stand for things."""
_SHORTEST = 2


@cache
def apart(name: str) -> str:
    """The name with spaces between its words, as it is where it is a word of its own."""
    if not name.isascii() or not name.isalpha() or not name.islower() or _known(name):
        return name
    for place in sorted(range(_SHORTEST, len(name) - 2), reverse=True):
        first, rest = name[:place], name[place:]
        single = normal(first) == first and _known(first)
        if (first in _PIECES or single) and _known(apart(rest).split()[0]):
            return f"{first} {apart(rest)}"
    return name


def _known(word: str) -> bool:
    if len(word) < 3:
        return word in _PIECES
    return any(
        known(each) for known in (nouns().knows, classes().knows) for each in (word, normal(word))
    )


def parted(name: str, heads: Collection[str]) -> tuple[str, ...]:
    """The two words of a name in one that ends with one of the heads: ``teapot``; the name where it does not."""
    for place in range(_SHORTEST, len(name) - 2):
        first, head = name[:place], name[place:]
        if head in heads and _known(first):
            return first, head
    return (name,)
