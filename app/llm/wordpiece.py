"""WordPiece: text → tokens as the BERT family reads it, lower-cased and without accents."""

import unicodedata
from collections.abc import Iterator, Mapping, Sequence

LONGEST_WORD = 100
"""Characters; longer words are unknown."""


class WordPiece:
    """A vocabulary, and the longest-match-first division of words by it."""

    def __init__(self, pieces: Sequence[str]) -> None:
        """Take the pieces in the order of their numbers; those within a word begin with ``##``."""
        self._number: Mapping[str, int] = {piece: n for n, piece in enumerate(pieces)}
        self._unknown = self._number["[UNK]"]
        self._ends = (self._number["[CLS]"], self._number["[SEP]"])

    def tokens(self, text: str, limit: int) -> list[int]:
        """The numbers of the text's pieces between those of start and end, ``limit`` at most."""
        found = [number for word in _words(text) for number in self._divide(word)]
        return [self._ends[0], *found[: limit - 2], self._ends[1]]

    def _divide(self, word: str) -> list[int]:
        if len(word) > LONGEST_WORD:
            return [self._unknown]
        found: list[int] = []
        start = 0
        while start < len(word):
            prefix = "##" if start else ""
            ends = range(len(word), start, -1)
            end = next((end for end in ends if prefix + word[start:end] in self._number), None)
            if end is None:
                return [self._unknown]
            found.append(self._number[prefix + word[start:end]])
            start = end
        return found


def _words(text: str) -> Iterator[str]:
    """Words, and every punctuation mark and ideograph by itself."""
    spaced: list[str] = []
    for character in unicodedata.normalize("NFD", text.lower()):
        category = unicodedata.category(character)
        if character in "\t\n\r":
            spaced.append(" ")
        elif category == "Mn" or category.startswith("C") or character == "\ufffd":
            continue
        elif _stands_alone(character, category):
            spaced.append(f" {character} ")
        else:
            spaced.append(character)
    yield from "".join(spaced).split()


def _stands_alone(character: str, category: str) -> bool:
    code = ord(character)
    symbol = 33 <= code <= 126 and not character.isalnum()
    return symbol or category.startswith("P") or any(a <= code <= b for a, b in IDEOGRAPHS)


IDEOGRAPHS = (
    (0x4E00, 0x9FFF),
    (0x3400, 0x4DBF),
    (0x20000, 0x2A6DF),
    (0x2A700, 0x2B73F),
    (0x2B740, 0x2B81F),
    (0x2B820, 0x2CEAF),
    (0xF900, 0xFAFF),
    (0x2F800, 0x2FA1F),
)
