"""WordNet → the classes of things that tasks speak of, each with familiar members.

Read once, when ``static/training/wordnet.json`` is made anew; generation needs only that file.
The database format is wndb(5WN): fixed fields separated by spaces, hyponym pointers ``~``.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

HYPONYMS = ("~", "~i")
MAX_MEMBERS = 60


@dataclass(frozen=True, slots=True)
class Synset:
    """One meaning: the words for it and the meanings it has below it."""

    words: tuple[str, ...]
    below: tuple[str, ...]
    """Offsets of its hyponyms in the data file."""


def read_synsets(folder: Path) -> dict[str, Synset]:
    """Every noun synset by its offset; words with spaces, as they are written."""
    synsets: dict[str, Synset] = {}
    for line in (folder / "data.noun").read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            continue
        fields = line.split(" | ")[0].split(" ")
        count = int(fields[3], 16)
        words = tuple(fields[4 + 2 * i].replace("_", " ") for i in range(count))
        pointers = fields[5 + 2 * count :]
        below = tuple(
            pointers[i + 1]
            for i in range(0, 4 * int(fields[4 + 2 * count]), 4)
            if pointers[i] in HYPONYMS
        )
        synsets[fields[0]] = Synset(words, below)
    return synsets


def first_senses(folder: Path) -> dict[str, tuple[str, ...]]:
    """Every noun's meanings, as offsets, the most frequent first."""
    senses: dict[str, tuple[str, ...]] = {}
    for line in (folder / "index.noun").read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            continue
        fields = line.split()
        senses[fields[0].replace("_", " ")] = tuple(fields[-int(fields[2]) :])
    return senses


def descendants(synsets: dict[str, Synset], root: str) -> Iterator[str]:
    """Offsets of all below ``root``, each once, in a fixed order."""
    seen: set[str] = set()
    waiting = list(synsets[root].below)
    while waiting:
        offset = waiting.pop(0)
        if offset not in seen:
            seen.add(offset)
            yield offset
            waiting += synsets[offset].below


def members(folder: Path, root: str, familiarity: Callable[[str], float]) -> list[str]:
    """Familiar words whose main meaning lies below ``root`` (``word#sense``), best known first."""
    synsets, senses = read_synsets(folder), first_senses(folder)
    word, _, number = root.partition("#")
    found: list[str] = []
    for offset in descendants(synsets, senses[word][int(number or 1) - 1]):
        for name in synsets[offset].words[:2]:
            plain = name.isascii() and name.replace(" ", "").isalpha() and name.islower()
            if plain and name.count(" ") < 2 and senses[name][0] == offset and name not in found:
                found.append(name)
    return sorted(found, key=familiarity, reverse=True)[:MAX_MEMBERS]


def write_classes(
    folder: Path, roots: dict[str, str], familiarity: Callable[[str], float], out: Path
) -> None:
    """Read every root's members and write them as one JSON object, class name → members."""
    classes = {name: members(folder, root, familiarity) for name, root in roots.items()}
    out.write_text(json.dumps(classes, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
