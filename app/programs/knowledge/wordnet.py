"""WordNet's concrete nouns: which meanings a noun has, and what they are kinds of."""

import gzip
from collections.abc import Iterable
from functools import cache
from pathlib import Path

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "nouns.txt.gz"
_RANKS = (1.0, 0.85, 0.65, 0.5, 0.4)
"""How likely the first, second … sense is meant where nothing was counted."""


class Nouns:
    """The nouns, read when they are first asked for (about 30 ms of CPU)."""

    def __init__(self, text: str) -> None:
        synsets, nouns, plurals = text.split("\n\n")
        self._above = _pairs(synsets)
        self._senses = _pairs(nouns)
        self.irregular = _pairs(plurals)
        """From irregular plurals to singulars."""
        self._closures: dict[str, frozenset[str]] = {}
        self._weights: dict[str, dict[str, float]] = {}

    def knows(self, noun: str) -> bool:
        """Whether it is a noun of WordNet with a concrete meaning."""
        return noun in self._senses

    def senses(self, noun: str) -> dict[str, float]:
        """The noun's meanings, each with how likely it is meant (the likeliest near 1)."""
        if noun not in self._weights:
            counted = [each.split(":") for each in self._senses.get(noun, "").split()]
            most = max((int(count) for _, count in counted), default=0) + 1
            self._weights[noun] = {
                synset: _RANKS[min(rank, 4)] * (0.6 + 0.4 * (int(count) + 1) / most)
                for rank, (synset, count) in enumerate(counted)
            }
        return self._weights[noun]

    def above(self, synset: str) -> frozenset[str]:
        """The meaning itself and all that it is a kind of."""
        if synset not in self._closures:
            found = {synset}
            for each in self._above.get(synset, "").split():
                found |= self.above(each)
            self._closures[synset] = frozenset(found)
        return self._closures[synset]

    def root(self, named: str) -> frozenset[str]:
        """The meanings of ``noun`` (all of its likely ones) or ``noun#2`` (its second)."""
        noun, _, number = named.partition("#")
        senses = self.senses(noun)
        if number:
            return frozenset(tuple(senses)[int(number) - 1 : int(number)])
        return frozenset(synset for synset, weight in senses.items() if weight >= 0.5)

    def is_a(self, noun: str, roots: Iterable[str]) -> float:
        """How likely the noun means something below one of the meanings, 0 to 1."""
        wanted = frozenset(roots)
        return max(
            (weight for each, weight in self.senses(noun).items() if self.above(each) & wanted),
            default=0.0,
        )

    def kind_of(self, noun: str, other: str) -> float:
        """How likely ``noun`` is a kind of ``other``, over the meanings of both."""
        return max(
            (
                weight * wide
                for each, weight in self.senses(noun).items()
                for synset, wide in self.senses(other).items()
                if synset in self.above(each)
            ),
            default=0.0,
        )

    def same(self, noun: str, other: str) -> float:
        """How likely the two are words for one thing."""
        mine, theirs = self.senses(noun), self.senses(other)
        return max((mine[each] * theirs[each] for each in mine if each in theirs), default=0.0)


@cache
def nouns() -> Nouns:
    """The nouns shipped with the service."""
    return Nouns(gzip.decompress(FILE.read_bytes()).decode("ascii"))


def _pairs(text: str) -> dict[str, str]:
    lines = (line.partition("\t") for line in text.splitlines())
    return {key: value for key, _, value in lines}
