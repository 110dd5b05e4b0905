"""Whether a word is English in any of its forms: what is none may be a slip."""

import gzip
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from app.programs.knowledge.word_lists import word_list

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "words.txt.gz"
_ENDINGS = (
    ("ies", "y"), ("ied", "y"), ("ier", "y"), ("iest", "y"), ("es", ""), ("s", ""), ("ed", ""),
    ("ed", "e"), ("ing", ""), ("ing", "e"), ("er", ""), ("er", "e"), ("est", ""), ("est", "e"),
)  # fmt: skip
"""Regular endings, and what a word has without them."""


def is_english(word: str) -> bool:
    """Whether WordNet has the word, or the one that it is a regular form of."""
    return word in word_list("small") or any(form in _words() for form in _forms(word))


def _forms(word: str) -> Iterator[str]:
    yield word
    for ending, left in _ENDINGS:
        stem = word.removesuffix(ending)
        if stem == word or len(stem) < 2:
            continue
        yield stem + left
        if not left and len(stem) > 3 and stem[-1] == stem[-2]:
            yield stem[:-1]  # cutting


@cache
def _words() -> frozenset[str]:
    """About 80,000 words (20 ms of CPU)."""
    return frozenset(gzip.decompress(FILE.read_bytes()).decode("ascii").splitlines()[1:])
