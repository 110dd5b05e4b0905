"""Everyday nouns, colours and sizes of other languages → English.

``static/knowledge/languages.json`` lists German, French, Spanish, Italian, Portuguese and Dutch
words for each English one.
"""

import json
import re
from collections.abc import Collection
from functools import cache
from pathlib import Path

from app.programs.knowledge.classes import classes, normal
from app.programs.knowledge.names import plain, words
from app.programs.knowledge.properties import COLOUR_WORDS, MATERIALS, SIZES
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "languages.json"
_ARTICLES = word_list("articles")
_ELIDED = re.compile(r"\b[ldLD]['\u2019](?=\w)")
_ADJECTIVES = word_list("adjectives")
_JOINTS = ("", "n", "en", "s", "e", "er")
"""What stands between the two words of a compound."""
_LONG = 5
"""Letters of the first word, where the second is as short as Dutch "la", a drawer."""
_ENDINGS = ("en", "er", "es", "em", "e", "n", "s", "i")
"""What a plural or a case adds."""


def in_english(text: str, *, surely: bool = True) -> str | None:
    """The text in English, where all of it can be read in another language.

    With ``surely`` only where WordNet does not know it; words of the classes are English always.
    """
    found = list(words(_ELIDED.sub("", text)))
    bare = [each for each in found if each not in _ARTICLES] or found
    if not bare or all(_english(each, rare=surely) for each in bare):
        return None
    whole = translated(" ".join(bare))
    if whole:
        return whole
    turned = [
        translated(each) or (each if _english(each, rare=True) or each.isdigit() else None)
        for each in bare
    ]
    if None in turned:
        return None
    kept = [each for each in turned if each]
    if kept == bare:
        return None
    adjectives = [each for each in kept if each in _ADJECTIVES]
    return " ".join(adjectives + [each for each in kept if each not in _ADJECTIVES])


def _english(word: str, *, rare: bool) -> bool:
    if word in COLOUR_WORDS or word in SIZES or word in MATERIALS or len(word) < 2:
        return True
    return any(
        classes().knows(each) or (rare and nouns().knows(each)) for each in (word, normal(word))
    )


def together(sentence: str) -> str:
    """With German and Dutch verbs of two parts in one: "mach die Dose zu", "doe de la open"."""
    for pattern, verbs in _PARTED:
        sentence = pattern.sub(
            lambda found, verbs=verbs: f"{verbs[found['part'].lower()]} {found['what']}", sentence
        )
    return sentence


_PARTED = (
    (
        re.compile(
            r"\bmach(?:st|t|e|en)?\b(?: (?:du|ihr|sie)\b)?(?: bitte)?(?: mal)? (?P<what>[^.,;!?]*?) (?P<part>auf|zu)\b"
            r"(?=\s*(?:[.,;!?]|$|und\b))",
            re.I,
        ),
        {"auf": "öffne", "zu": "schließe"},
    ),
    (
        re.compile(
            r"\b(?:doe|doet|maak|maakt)\b(?: je\b)?(?: even| eens)* (?P<what>[^.,;!?]*?) (?P<part>open|dicht)\b"
            r"(?=\s*(?:[.,;!?]|$|en\b))",
            re.I,
        ),
        {"open": "open", "dicht": "sluit"},
    ),
)


def translated(word: str, wanted: Collection[str] = ()) -> str | None:
    """The English for a word as ``plain`` makes it, whatever its ending.

    Of several meanings it is one that is ``wanted``, if any is: Spanish "cubo" is a cube or a bucket.
    """
    found = _meanings(word)
    fitting = (each for each in found if each in wanted or each.replace(" ", "") in wanted)
    return next(fitting, found[0] if found else None)


def _meanings(word: str) -> tuple[str, ...]:
    table = _table()
    if word in table:
        return table[word]
    for ending in _ENDINGS:
        stem = word.removesuffix(ending)
        if stem != word and len(stem) > 2 and _ending_in(stem, ending):
            return _ending_in(stem, ending)
    if match := re.fullmatch(r"(.+)([aeou])([^aeiou])en", word):  # Dutch potloden of potlood
        return table.get(f"{match[1]}{match[2] * 2}{match[3]}", ())
    return _compound(word)


def _ending_in(stem: str, ending: str) -> tuple[str, ...]:
    """The meanings of the stem, whatever a plural or a case added: Italian biscotti are of biscotto."""
    vowels = ("o", "e", "") if ending == "i" else ("", "e")
    return next((found for each in vowels if (found := _table().get(f"{stem}{each}"))), ())


def _compound(word: str) -> tuple[str, ...]:
    """A word of two in one, as German and Dutch make them: the Küchenschublade is a kitchen drawer."""
    table = _table()
    found: list[str] = []
    for cut in range(3, len(word) - 1):
        if len(word) - cut < 4 and cut < _LONG:
            continue
        second = table.get(word[cut:], ())
        stems = [word[:cut].removesuffix(joint) for joint in _JOINTS if second]
        first = [
            one for stem in stems for form in (stem, f"{stem}e") for one in table.get(form, ())
        ]
        found += [f"{one} {other}" for one in first for other in second]
    return tuple(dict.fromkeys(found))


@cache
def _table() -> dict[str, tuple[str, ...]]:
    entries = json.loads(FILE.read_text(encoding="utf-8"))
    found: dict[str, tuple[str, ...]] = {}
    for english, others in entries.items():
        for other in others.split(","):
            word = " ".join(words(plain(other)))
            for form in {word, word.replace("'", " ")}:
                found[form] = (*found.get(form, ()), english)
    return found
