"""WordNet's database files → the lists of concrete nouns and of all words in ``static/knowledge``.

Run once, when these files are made anew. The database's format is wndb(5WN): fixed fields separated by
spaces, hypernym pointers ``@``; how often a sense was met stands in ``cntlist.rev``.
"""

import gzip
from dataclasses import dataclass
from pathlib import Path

HYPERNYMS = ("@", "@i")
CONCRETE = frozenset((3, 5, 6, 8, 10, 13, 17, 18, 20, 21, 25, 27))
"""Lexicographer files: tops, animals, artefacts, body, communication, food, natural objects, persons,
plants, possessions, shapes, substances."""
HEAD = "WordNet 3.0 nouns: see NOTICE"


@dataclass(frozen=True, slots=True)
class Synset:
    """One meaning: the words for it and the meanings it is a kind of."""

    words: tuple[str, ...]
    above: tuple[str, ...]
    concrete: bool


def write_nouns(folder: Path, out: Path) -> None:
    """Read the database in ``folder`` and write the nouns, gzipped, the same bytes each time.

    Three parts with empty lines between them, tab-separated: synset number, the numbers of its
    hypernyms; noun, its senses as ``number:times met``, the most frequent first; irregular plural,
    its singular.
    """
    synsets = _synsets(folder)
    kept = _with_above(synsets)
    numbers = {offset: number for number, offset in enumerate(sorted(kept))}
    met = _counts(folder)
    lines = [HEAD]
    for offset, number in numbers.items():
        above = " ".join(f"{numbers[each]}" for each in synsets[offset].above)
        lines.append(f"{number}\t{above}")
    lines.append("")
    for noun, senses in _senses(folder).items():
        shown = [
            f"{numbers[each]}:{met.get((noun, place), 0)}"
            for place, each in enumerate(senses, start=1)
            if each in numbers and synsets[each].concrete
        ]
        if shown and noun.isascii():
            lines.append(f"{noun.replace('_', ' ')}\t{' '.join(shown)}")
    lines.append("")
    for line in (folder / "noun.exc").read_text(encoding="utf-8").splitlines():
        plural, singular = line.split()[:2]
        if plural != singular and plural.isascii() and "_" not in plural:
            lines.append(f"{plural}\t{singular}")
    text = "\n".join(lines) + "\n"
    out.write_bytes(gzip.compress(text.encode("ascii"), 9, mtime=0))


def write_words(folder: Path, out: Path) -> None:
    """Write every single word of the database and every irregular form, sorted, gzipped."""
    found: set[str] = set()
    for kind in ("noun", "verb", "adj", "adv"):
        for name in (f"index.{kind}", f"{kind}.exc"):
            lines = (folder / name).read_text(encoding="utf-8").splitlines()
            found |= {line.split()[0] for line in lines if not line.startswith("  ")}
    kept = sorted(word for word in found if word.isascii() and word.isalpha() and len(word) > 2)
    text = "\n".join((HEAD.replace("nouns", "words"), *kept)) + "\n"
    out.write_bytes(gzip.compress(text.encode("ascii"), 9, mtime=0))


def _synsets(folder: Path) -> dict[str, Synset]:
    found: dict[str, Synset] = {}
    for line in (folder / "data.noun").read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            continue
        fields = line.split(" | ")[0].split(" ")
        count = int(fields[3], 16)
        words = tuple(fields[4 + 2 * i] for i in range(count))
        start = 5 + 2 * count
        pointers = [
            fields[start + 4 * i : start + 4 * i + 2] for i in range(int(fields[start - 1]))
        ]
        above = tuple(offset for symbol, offset in pointers if symbol in HYPERNYMS)
        named = all(word[0].isupper() for word in words)
        found[fields[0]] = Synset(words, above, int(fields[1]) in CONCRETE and not named)
    return found


def _with_above(synsets: dict[str, Synset]) -> set[str]:
    """The concrete ones and all that is above them."""
    kept: set[str] = set()
    waiting = [offset for offset, synset in synsets.items() if synset.concrete]
    while waiting:
        offset = waiting.pop()
        if offset not in kept:
            kept.add(offset)
            waiting += synsets[offset].above
    return kept


def _senses(folder: Path) -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for line in (folder / "index.noun").read_text(encoding="utf-8").splitlines():
        if not line.startswith("  "):
            fields = line.split()
            found[fields[0]] = tuple(fields[-int(fields[2]) :])
    return found


def _counts(folder: Path) -> dict[tuple[str, int], int]:
    """How often each sense of a noun was met in tagged text, by its number."""
    found: dict[tuple[str, int], int] = {}
    for line in (folder / "cntlist.rev").read_text(encoding="utf-8").splitlines():
        key, number, count = line.split()
        noun, _, rest = key.partition("%")
        if rest.startswith("1:"):
            found[noun, int(number)] = int(count)
    return found
