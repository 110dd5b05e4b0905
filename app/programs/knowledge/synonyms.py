"""Words for the same thing: everyday groups, and WordNet's."""

import json
from functools import cache
from pathlib import Path

from app.programs.knowledge.classes import normal
from app.programs.knowledge.wordnet import nouns

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "synonyms.json"
SURE = 0.45


def mean_the_same(noun: str, other: str) -> bool:
    """Whether the two, as ``normal`` makes them, are words for one thing."""
    if noun == other or _groups().get(noun, frozenset()) & _groups().get(other, frozenset()):
        return True
    return nouns().same(noun, other) >= SURE


@cache
def _groups() -> dict[str, frozenset[int]]:
    """The groups each noun is in, by number."""
    found: dict[str, set[int]] = {}
    for number, line in enumerate(json.loads(FILE.read_text(encoding="utf-8"))):
        for noun in line.split(","):
            found.setdefault(normal(noun), set()).add(number)
    return {noun: frozenset(numbers) for noun, numbers in found.items()}
