"""Drafts: what usually follows in an adapted model's sketches, so that it checks more than it writes.

A sketch is made of few words, many of which can be foreseen: ``grab_and_putin('`` after ``grab``.
llama.cpp guesses from such statistics (its static n-gram cache) and has the model check a handful
of tokens in one pass, which costs little more than writing one. A wrong guess is thrown away:
what comes out is the same text.
"""

import struct
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

BEFORE = 2
"""Tokens that the next one is foreseen from; the library's own number."""
RARE = 3
"""Seen less often, two tokens foresee nothing."""
LIKELY = 0.5
"""The share that the likeliest token has to have for a guess; the library's own, too."""
LEAST_SHARE = 0.1
"""Of what follows two tokens, rarer ones are left out."""
_PLACES = 4
"""For tokens in one entry of the file; those not used hold ``_NONE``."""
_NONE = -1

Pair = tuple[Sequence[int], Sequence[int]]
"""The tokens of a prompt, and of what a model is to write after it."""


def followers(pairs: Iterable[Pair]) -> dict[tuple[int, ...], dict[int, int]]:
    """How often which token follows two others in what is written."""
    seen: defaultdict[tuple[int, ...], Counter[int]] = defaultdict(Counter)
    for prompt, answer in pairs:
        tokens = [*prompt[-BEFORE:], *answer]
        for place in range(BEFORE, len(tokens)):
            seen[tuple(tokens[place - BEFORE : place])][tokens[place]] += 1
    table: dict[tuple[int, ...], dict[int, int]] = {}
    for before, after in sorted(seen.items()):
        total = after.total()
        if total >= RARE and max(after.values()) >= LIKELY * total:
            table[before] = {t: n for t, n in after.items() if n >= LEAST_SHARE * total}
    return table


def write_drafts(path: Path, table: Mapping[tuple[int, ...], Mapping[int, int]]) -> None:
    """The table as llama.cpp reads it.

    Entry after entry of 32-bit integers: two tokens and two places not used, how many tokens
    follow, and each of them with its number.
    """
    entries = bytearray()
    for before, after in table.items():
        unused = [_NONE] * (_PLACES - len(before))
        counts = [number for pair in sorted(after.items()) for number in pair]
        row = [*before, *unused, len(after), *counts]
        entries += struct.pack(f"<{len(row)}i", *row)
    path.write_bytes(bytes(entries))
