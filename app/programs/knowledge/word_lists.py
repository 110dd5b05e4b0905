"""Lists of words that the reading of names and phrases needs, from ``static/knowledge/words.json``."""

import json
from functools import cache
from pathlib import Path

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "words.json"


@cache
def _lists() -> dict[str, str]:
    return json.loads(FILE.read_text(encoding="utf-8"))


def word_list(name: str) -> frozenset[str]:
    """The list of this name; its words are separated by commas."""
    return frozenset(each.strip() for each in _lists()[name].split(","))
