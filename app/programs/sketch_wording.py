"""What somebody typed → plain English without slips, for the model that reads the sentence.

A sentence in another language is put into English word by word, which is enough for "lay the apple
into the bowl" in the languages at hand. A word that no dictionary knows, and that is one of the
scene's words but for a letter or two, is taken to be that word.
"""

import difflib
import json
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from app.programs.knowledge.languages import translated
from app.programs.knowledge.names import plain, words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketch_matching import misspelt

FILE = Path(__file__).parents[2] / "static" / "knowledge" / "grammar.json"
ALIKE = 0.8
_TOKEN = re.compile(r"[^\W\d_]+(?:[\u2019'][^\W\d_]+)*|[^\w\s]|\S+|\s+")
_ENGLISH = word_list("english")


def plain_english(sentence: str, names: Sequence[str]) -> str:
    """The sentence as it is, or in English and without slips where it was not."""
    if any("\u4e00" <= letter <= "\u9fff" for letter in sentence):
        return _unspaced(sentence)
    if _is_foreign(sentence, names):
        return _glossed(sentence, names)
    return _mended(sentence, names)


def _is_foreign(sentence: str, names: Sequence[str]) -> bool:
    """Whether more of its small words belong to another language than to English."""
    quoted = {word for name in names for word in words(name)}
    said = [word for word in words(sentence.replace("'", " ")) if word not in quoted]
    english = sum(word in _ENGLISH for word in said)
    other = sum(word in _small_words() and word not in _ENGLISH for word in said)
    return other >= 2 and other > 2 * english


def _glossed(sentence: str, names: Sequence[str]) -> str:
    """Word by word in English; adjectives of Romance languages come before their nouns."""
    known = {word for name in names for word in words(name)}
    tokens = [
        each for each in _TOKEN.findall(sentence.replace("\u2019", "'")) if not each.isspace()
    ]
    parts = [part for token in tokens for part in re.split(r"(?<=^[ldLD])'", token)]
    found: list[str] = []
    place = 0
    while place < len(parts):
        length, english = _longest(parts, place, known)
        found.append(english)
        place += length
    text = " ".join(each for each in found if each)
    text = re.sub(
        rf"\b((?!the\b|a\b|in\b|on\b|and\b|all\b)[a-z]+) ({_ADJECTIVES})\b", r"\2 \1", text
    )
    text = re.sub(r"\b(please)(?: of)? (?:please|the please)\b", r"\1", text)
    return re.sub(r"\s+([,.!?])", r"\1", re.sub(r"\b(the|a) (the|a)\b", r"\1", text))


_ADJECTIVES = "red|blue|green|yellow|black|white|brown|grey|pink|purple|big|small|wooden"


def _longest(parts: Sequence[str], place: int, known: set[str]) -> tuple[int, str]:
    """How many words from here on are one English word, and that word."""
    for length in (3, 2, 1):
        text = plain(" ".join(parts[place : place + length]))
        if length > 1 and len(parts) - place >= length:
            if text in _small_words():
                return length, _small_words()[text]
            if noun := translated(text):
                return length, noun
    word = plain(parts[place])
    if word in _small_words():
        return 1, _small_words()[word]
    if noun := translated(word):
        return 1, f"{noun}s" if _looks_plural(parts, place) and not noun.endswith("s") else noun
    return 1, parts[place] if word in known or not word.isalpha() else word


def _looks_plural(parts: Sequence[str], place: int) -> bool:
    """Whether "all" or a number stands before it, with articles between."""
    before = [
        _small_words().get(plain(each), plain(each)) for each in parts[max(0, place - 3) : place]
    ]
    while before and (before[-1] == "the" or translated(before[-1])):
        before.pop()
    return bool(before) and before[-1] in ("all", "two", "three", "four")


def _mended(sentence: str, names: Sequence[str]) -> str:
    """With each unknown word that is almost one of the scene's put right."""
    scene = {word for name in names for word in words(name) if word.isalpha() and len(word) > 2}
    slips = _grammar()["slips"]
    singulars = scene | {f"{word}s" for word in scene}

    def mend(match: re.Match[str]) -> str:
        word = plain(match[0])
        if word in slips and word not in singulars:
            return slips[word]
        if len(word) < 4 or word in singulars or word in _ENGLISH or not misspelt(word):
            return match[0]
        return _nearest(word, singulars) or match[0]

    return " ".join(re.sub(r"[^\W\d_]+", mend, sentence).split())


def _nearest(word: str, known: set[str]) -> str | None:
    """The known word that this one is with a slip in it."""
    near = difflib.get_close_matches(word, sorted(known), 1, ALIKE)
    if not near:
        near = [each for each in sorted(known) if sorted(each) == sorted(word)]
    return near[0] if near and near[0][0] == word[0] else None


def _unspaced(sentence: str) -> str:
    """A sentence written without spaces, the longest known word first."""
    table = _grammar()["unspaced"]
    text = sentence
    for word in sorted(table, key=len, reverse=True):
        text = text.replace(word, f" {table[word].strip()} ")
    return " ".join(re.sub(r"\b(put|in)\b", r"\1 the", text).split())


@cache
def _small_words() -> dict[str, str]:
    found: dict[str, str] = {}
    for english, others in _grammar()["spaced"].items():
        for other in others.split(","):
            found.setdefault(plain(other.strip()), english)
    return found


@cache
def _grammar() -> dict[str, dict[str, str]]:
    return json.loads(FILE.read_text(encoding="utf-8"))
