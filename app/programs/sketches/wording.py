"""What somebody typed → plain English without slips, for the model that reads the sentence.

A sentence in another language is put into English word by word, which is enough for "lay the apple
into the bowl" in the languages at hand. A word that no dictionary knows, and that is one of the
scene's words but for a letter or two, is taken to be that word.
"""

import difflib
import json
import re
from collections.abc import Collection, Mapping, Sequence
from functools import cache
from pathlib import Path

from app.programs.knowledge.classes import classes
from app.programs.knowledge.english import is_english
from app.programs.knowledge.languages import together, translated
from app.programs.knowledge.names import plain, singular, words
from app.programs.knowledge.properties import COLOUR_WORDS, MATERIALS, SIZES
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.asides import without_thoughts
from app.programs.sketches.counting_off import counted_off
from app.programs.sketches.foreign_asides import without_reasons
from app.programs.sketches.matching import misspelt
from app.programs.sketches.rephrasing import rephrased
from app.programs.sketches.speakers import without_doings
from app.programs.sketches.timing import timeless
from app.programs.sketches.topics import named_whole

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "grammar.json"
ALIKE = 0.8
HASTY = 2
"""From so many slips on, a word that exists may be one as well."""
SURELY = 0.85
"""The same for words that the scene does not have."""
LONG = 8
"""Letters from which a word is like another one though more of it is wrong."""
_TOKEN = re.compile(r"[^\W\d_]+(?:[\u2019'][^\W\d_]+)*|[^\w\s]|\S+|\s+")
_ENGLISH = word_list("english")
_DUTCH = word_list("dutch")
_COMMON = word_list("common")
"""Words of which a slip is put right though no thing is called so."""
_PLURAL_ARTICLES = frozenset(("les", "las", "los", "gli", "os", "as", "des"))


def plain_english(sentence: str, names: Sequence[str]) -> str:
    """The sentence as it is, or in English and without slips where it was not."""
    if any("\u4e00" <= letter <= "\u9fff" for letter in sentence):
        return _unspaced(sentence)
    if _is_foreign(sentence, names):
        sentence = without_reasons(sentence)
        return rephrased(_verb_first(_glossed(together(sentence), names)))
    return rephrased(without_thoughts(_plainly(_mended(sentence, names))))


def _plainly(sentence: str) -> str:
    """Without what others do and when, and with the number of the others of a kind."""
    return named_whole(counted_off(timeless(without_doings(sentence))))


def _is_foreign(sentence: str, names: Sequence[str]) -> bool:
    """Whether more of its small words belong to another language than to English."""
    quoted = {word for name in names for word in words(name)}
    said = [word for word in words(sentence.replace("'", " ")) if word not in quoted]
    english = sum(word in _ENGLISH for word in said)
    other = sum(word in _small_words() and word not in _ENGLISH for word in said)
    return other >= 2 and other > 2 * english


def _glossed(sentence: str, names: Sequence[str]) -> str:
    """Word by word in English; adjectives of Romance languages come before their nouns."""
    known = {word for name in names for word in (*words(name), plain(name))}
    tokens = [
        each for each in _TOKEN.findall(sentence.replace("\u2019", "'")) if not each.isspace()
    ]
    parts = [part for token in tokens for part in re.split(r"(?<=^[ldLD])'", token)]
    # Where French and Spanish say "in" and "of", the Dutch say "and" and "the".
    also = {"en": "and", "la": "drawer"} if set(map(plain, parts)) & _DUTCH else {"de": "of"}
    found: list[str] = []
    place = 0
    while place < len(parts):
        length, english = _longest(parts, place, known, also)
        english = _portuguese(parts, place, found) or english if length == 1 else english
        found.append(english)
        place += length
    text = " ".join(each for each in found if each)
    text = re.sub(
        rf"\b((?!the\b|a\b|in\b|on\b|and\b|all\b)[a-z]+) ({_ADJECTIVES})\b", r"\2 \1", text
    )
    text = " ".join(re.sub(r"\b(?:of )?(?:the )?please\b", "", text).split())
    for first, second in (words(name) for name in names if len(words(name)) == 2):
        turned = rf"\b{singular(second)}s? (?:of |the )+{singular(first)}s?\b"
        text = re.sub(turned, f"{first} {second}", text)
    text = text.lstrip(" ,")
    return re.sub(r"\s+([,.!?])", r"\1", re.sub(r"\b(the|a) (the|a)\b", r"\1", text))


def _verb_first(text: str) -> str:
    """With verbs from a clause's end at its beginning: "the toolbox open" is an order to open it."""
    return _VERB_LAST.sub(r"\g<before>\g<verb> \g<what>", text)


_VERB_LAST = re.compile(
    r"(?P<before>^\W*|[.!?,;] |\band )(?P<what>(?:the|all|both|a|my|your)\b(?:(?!\b(?:put|open|close|pour|push|take|stack|stays|and)\b)[^.!?;])*?) "
    r"(?P<verb>put|open|close|pour|push|take|stack)(?=\s*[.!?,;]|$| and\b)",
    re.I,
)


def _portuguese(parts: Sequence[str], place: int, found: Sequence[str]) -> str | None:
    """What two small words are there: "põe a maçã no saco", but Spanish "no el limón"."""
    word, following = plain(parts[place]), plain(parts[place + 1]) if place + 1 < len(parts) else ""
    if word == "a" and found[-1:] and found[-1] in ("put", "and", "open", "close", "pour"):
        return "the"
    if word == "no" and _small_words().get(following) not in ("the", "a", "all", "both"):
        return "in the"
    return None


_ADJECTIVES = "red|blue|green|yellow|black|white|brown|grey|pink|purple|big|small|wooden"


def _longest(
    parts: Sequence[str], place: int, known: set[str], also: Mapping[str, str]
) -> tuple[int, str]:
    """How many words from here on are one English word, and that word; ``also`` has single ones."""
    for length in (4, 3, 2, 1):
        text = plain(" ".join(parts[place : place + length]))
        if length > 1 and len(parts) - place >= length:
            if text in _small_words():
                return length, _small_words()[text]
            if noun := translated(text, known):
                return length, noun
    word = plain(parts[place])
    if word in also or word in _small_words():
        return 1, also.get(word) or _small_words()[word]
    if noun := translated(word, known):
        several = _looks_plural(parts, place) and not noun.endswith("s") and not _is_quality(noun)
        return 1, f"{noun}s" if several else noun
    return 1, parts[place] if word in known or not word.isalpha() else word


def _is_quality(word: str) -> bool:
    return word in COLOUR_WORDS or word in MATERIALS or word in SIZES


def _looks_plural(parts: Sequence[str], place: int) -> bool:
    """Whether "all", a number or an article of several stands before it."""
    if place and plain(parts[place - 1]) in _PLURAL_ARTICLES:
        return True
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
    singulars = scene | {_several(word) for word in scene}
    sentence = _paired(_apart(_joined(sentence, names), scene), names)
    strange = (each for each in words(sentence) if each.isalpha() and each not in singulars)
    hasty = sum(len(each) > 3 and each not in _ENGLISH and not is_english(each) for each in strange)

    def mend(match: re.Match[str]) -> str:
        word = plain(match[0])
        if word in slips and word not in singulars:
            return slips[word]
        if hasty >= HASTY and len(word) > 4 and word not in singulars | _ENGLISH:
            # Who misspells so much may hit another word: "bowel" for the bowl.
            near = difflib.get_close_matches(word, sorted(scene), 1, SURELY)
            if near and near[0][0] == word[0]:
                return near[0]
        if len(word) < 4 or word in singulars | _ENGLISH or is_english(word):
            return match[0]
        kind = _nearest(word, _kinds(), SURELY) if len(word) > 4 else None
        kind = kind or _misspelt_kind(word)
        return _nearest(word, singulars) or kind or _slipped(word) or match[0]

    return " ".join(re.sub(r"(?<!\d)[^\W\d_]+", mend, sentence).split())


def _joined(sentence: str, names: Sequence[str]) -> str:
    """With names of the scene that were written as one word apart: the ``penciltin``."""
    for name in names:
        said = words(name)
        if len(said) == 2 and said[1].isalpha():
            whole = re.escape("".join(said))
            sentence = re.sub(rf"\b{whole}\b", name, sentence, flags=re.I)
    return sentence


def _apart(sentence: str, scene: Collection[str]) -> str:
    """With small words apart that were run together with one of the scene's: ``thebook``, ``inthe``."""
    whole = "|".join(map(re.escape, sorted({*scene, "the", "my"}, key=len, reverse=True)))
    return re.sub(
        rf"\b(the|my|in|on|into|onto|and|put)({whole})\b",
        lambda match: f"{match[1]} {match[2]}" if misspelt(match[0].lower()) else match[0],
        sentence,
        flags=re.I,
    )


def _paired(sentence: str, names: Sequence[str]) -> str:
    """With a real word that was written for its neighbour put right: ``sowing box``, ``sewing box``."""
    for name in names:
        said = words(name)
        if len(said) != 2 or not all(map(str.isalpha, said)):
            continue
        for match in re.finditer(rf"\b([a-z]+) {re.escape(said[1])}\b", sentence, re.I):
            word = plain(match[1])
            ratio = difflib.SequenceMatcher(None, word, said[0]).ratio()
            if word != said[0] and word[0] == said[0][0] and len(word) > 4 and ratio > ALIKE:
                sentence = f"{sentence[: match.start()]}{name}{sentence[match.end() :]}"
                break
    return sentence


@cache
def _kinds() -> frozenset[str]:
    """Words for classes of things, and for colours."""
    named = {each for each in classes().names() if each.isalpha() and len(each) > 3}
    named |= {head for each in classes().names() if len(head := each.rpartition(" ")[2]) > 6}
    several = {f"{each}s" for each in named} | {f"{each[:-1]}ies" for each in named}
    return frozenset(named | several | set(COLOUR_WORDS))


def _misspelt_kind(word: str) -> str | None:
    """The long class word of as many letters that this one is, though more of it is wrong."""
    if len(word) < LONG:
        return None
    return _nearest(word, {each for each in _kinds() if abs(len(each) - len(word)) < 2}, ALIKE)


def _slipped(word: str) -> str | None:
    """The common word that this one is but for a slip of the fingers; "wild" only sounds like "would"."""
    turned = [each for each in sorted(_COMMON) if sorted(each) == sorted(word)]
    near = turned or difflib.get_close_matches(word, sorted(_COMMON), 1, SURELY)
    bent = near and word.startswith(near[0])  # "closed" is no slip
    return near[0] if near and near[0][0] == word[0] and not bent else None


def _several(word: str) -> str:
    return f"{word}es" if word.endswith(("s", "sh", "ch", "x", "z")) else f"{word}s"


def _nearest(word: str, known: Collection[str], alike: float = ALIKE) -> str | None:
    """The known word that this one is with a slip in it, or sounds like."""
    near = difflib.get_close_matches(word, sorted(known), 1, alike)
    if not near:
        near = [each for each in sorted(known) if sorted(each) == sorted(word)]
    if not near:
        near = [each for each in sorted(known) if sounds(each) == sounds(word)]
    return near[0] if near and near[0][0] == word[0] else None


def sounds(word: str) -> str:
    """The word as it is heard, roughly: ``sizzors`` sounds like scissors."""
    for pattern, sound in _SOUNDS:
        word = re.sub(pattern, sound, word)
    return word


_SOUNDS = (
    (r"sc(?=[eiy])|c(?=[eiy])|z", "s"),
    (r"ck|c|q", "k"),
    (r"ph", "f"),
    (r"kn", "n"),
    (r"wr", "r"),
    (r"gh(?=t)", ""),
    (r"(.)\1+", r"\1"),
    (r"(?<=[aeiou])w(?![aeiou])|(?<=[bcdfghjklmnpqrstvwxz])e$", ""),
    (r"[aeiouy]+", "a"),
)


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
