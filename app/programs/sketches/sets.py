"""What "everything" and "the cutlery" take in: which things count among a set nobody lists."""

import re
from collections.abc import Sequence
from dataclasses import replace

from app.programs.knowledge.classes import VAGUE, classes, normal
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.qualities import is_container
from app.programs.sketches.rephrasing import STAYS
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing

COLLECTIVE = word_list("collective")
"""Words that stand for all of a kind without a plural."""
_STORING = word_list("storing")
_SERVING = ("bowl", "plate", "dish", "platter")


def is_plural(phrase: Phrase) -> bool:
    found = words(phrase.text)
    return phrase.quantity == "one" and bool(found) and normal(found[-1]) != found[-1]


def really_said(phrase: Phrase, sentence: str, things: Sequence[Thing]) -> Phrase:
    """With the word for all of a kind that the sentence says, where the sketch has no more than "things"."""
    said = words(sentence)
    named = {word for thing in things for word in thing.words}
    if _vague_set(phrase) and (shared := _shared_by_names(said, things)):
        return replace(phrase, text=shared)
    kinds = {each for each in said if each in COLLECTIVE - VAGUE - named}
    if not _vague_set(phrase) or len(kinds) != 1 or set(said) & (VAGUE | _EVERYTHING):
        return phrase
    return replace(phrase, text=kinds.pop())


def _vague_set(phrase: Phrase) -> bool:
    """Whether it is of everything, as far as its words go."""
    return set(words(phrase.text)) <= VAGUE and phrase.quantity == "all" and not phrase.relations


def _shared_by_names(said: Sequence[str], things: Sequence[Thing]) -> str | None:
    """The plural that is said of what several names begin with: the leftovers, ``leftover rice``."""
    firsts = [thing.words[0] for thing in things if len(thing.words) > 1]
    found = {each for each in said if normal(each) != each and firsts.count(normal(each)) > 1}
    return found.pop() if len(found) == 1 else None


_EVERYTHING = frozenset(("all", "whatever", "what", "it", "them", "lot", "both", "every", "each"))


def movable(found: Sequence[Thing], selection: Selection, *, placed: bool = False) -> list[Thing]:
    """What "everything" means: no furniture, and nothing that stands there to be filled.

    Where another place is told (``placed``), plates and bowls are things like others.
    """
    kept = [t for t in found if not _stores(t)] or list(found)
    serving = [t for t in kept if t.core and normal(t.core[-1]) in _SERVING]
    others = [t for t in kept if t not in serving]
    crockery = [t for t in others if _is(t, "dish") or _is(t, "cutlery")]
    if serving and others and not crockery and not placed:
        kept = others
    held = {t.name for t in kept if any(selection.rests(t.name, other.name) for other in kept)}
    return [t for t in kept if t.name not in held] or list(kept)


def _stores(thing: Thing) -> bool:
    if not thing.core:
        return False
    head = normal(thing.core[-1])
    if head == "can":
        return _is(thing, "container") and thing.unmarked in (
            "trash can",
            "garbage can",
            "waste can",
        )
    if head in ("case", "bag", "box") and not is_container(thing):
        return False
    food = any(_is(thing, kind) for kind in ("food", "drink", "stationery", "medicine"))
    return (head in _STORING or _is(thing, "furniture")) and not food


def _is(thing: Thing, kind: str) -> bool:
    return belonging(thing.name, classes().named(kind)) >= 0.5


def counted(phrase: Phrase, sentence: str) -> Phrase:
    """With the number that the sentence says before the words: "one of the eggs", "two eggs"."""
    if phrase.quantity != "all":
        return phrase
    if phrase.count and phrase.count > 1 and _of_the_clock(phrase.count, sentence):
        phrase = replace(phrase, count=None)
    if phrase.count == 1 and _several(phrase, sentence):
        phrase = replace(phrase, count=None)
    if re.search(
        rf"\bboth (?:of )?(?:the |my |your |these |those )?{re.escape(phrase.text)}\b",
        sentence,
        re.I,
    ):
        return replace(phrase, count=None)
    spoken = r"\s+".join(map(re.escape, phrase.text.split()))
    if re.search(
        rf"\ball (?:of )?(?:the |my |your |these |those )?{spoken}(?:e?s)?\b", sentence, re.I
    ):
        # The number is of something else: "all the eggs, one in each cup".
        phrase = replace(phrase, count=None if phrase.count == 1 else phrase.count)
    other = phrase.count is not None and _of_others(phrase, sentence)
    if phrase.count is not None and not (other or re.search(r"\bof the \w+ ", sentence, re.I)):
        return phrase
    pattern = rf"(?<!every )(?<!each )\b({'|'.join(_NUMBERS)})\s+(?:(?:out )?of\s+(?:the|these|those|my|your)\s+(?:(?:{'|'.join(_NUMBERS)})\s+)?)?{spoken}\b"
    said = {_NUMBERS[each.lower()] for each in re.findall(pattern, sentence, re.I)}
    return replace(phrase, count=said.pop()) if len(said) == 1 else phrase


def _several(phrase: Phrase, sentence: str) -> bool:
    """Whether the words are a plural that nothing says one is of: "just the small pots"."""
    single = normal(phrase.text)
    told = _ONE.format(re.escape(single.split()[-1])) if single else ""
    return single not in ("", phrase.text) and not re.search(told, sentence, re.I)


def _of_others(phrase: Phrase, sentence: str) -> bool:
    """Whether the sentence says the number of other things alone: "I'm only playing nine holes"."""
    names = "|".join(name for name, value in _NUMBERS.items() if value == phrase.count)
    own = normal(phrase.text).split()[-1:]
    said = re.findall(rf"\b(?:{names})\b ?(\w*)", sentence, re.I) if names else []
    return bool(said) and all(normal(each) not in (each, *own) for each in said)


def _of_the_clock(count: int, sentence: str) -> bool:
    """Whether all that the sentence says of the number is a time or an age: "we fly at six"."""
    names = "|".join(name for name, value in _NUMBERS.items() if value == count)
    if not names:
        return False
    told = rf"\b(?:{names})\b"
    timed = (
        rf"\b(?:at|by|past|to|till|until|before|after|since|around|about|table|room|number|page|aged?|turns|is|'s)"
        rf" (?:{names})\b(?=\s*(?:[.,;:!?)]|$|o'clock|[ap]\.?m|sharp|tonight|today|tomorrow|already|and\b|so\b|wants?\b|in the (?:morning|afternoon|evening)|at night))|"
        rf"\b(?:{names})(?:[- ]year|(?: minutes| hours| days| weeks| years| o'clock|[ap]m| euros?| pounds?| dollars?)\b)"
    )
    return 0 < len(re.findall(told, sentence, re.I)) == len(re.findall(timed, sentence, re.I))


def halved(phrase: Phrase, sentence: str, found: int) -> Phrase:
    """With half of what is found as its number, where the sentence says "half of the eggs"."""
    spoken = r"\s+".join(map(re.escape, phrase.text.split()))
    them = phrase.quantity == "all" and re.search(
        r"\bhalf of (?:them|these|those)\b", sentence, re.I
    )
    half = them or re.search(
        rf"\bhalf\s+(?:of\s+)?(?:the|these|those|my|your)?\s*(?:\w+\s+)?{spoken}\b", sentence, re.I
    )
    return replace(phrase, count=found // 2) if half and found > 1 else phrase


def left_over(phrase: Phrase, sentence: str, found: int) -> Phrase:
    """With all but so many as its number: "leave one egg and put the others in the basket"."""
    match = _how_many_stay(sentence)
    if not match or not words(phrase.text):
        return phrase
    left = _NUMBERS[match["number"].lower()]
    spoken = {normal(each) for each in words(match["noun"])}
    same = bool({normal(phrase.text).split()[-1], "one", "them"} & spoken)
    same = same and phrase.count in (None, left)
    return replace(phrase, count=found - left) if same and found > left else phrase


def but_some(phrase: Phrase, sentence: str) -> Phrase:
    """Without what is left out where that is so many of its own kind: "leave me one spoon"."""
    match = _how_many_stay(sentence)
    found = words(phrase.text)
    if not match or not found:
        return phrase
    own = normal(phrase.text).split()[-1]
    same = bool({own, "one", "them"} & {normal(each) for each in words(match["noun"])})
    kept = tuple(
        each
        for each in phrase.but
        if own not in {normal(w) for w in words(each)} and each not in _NUMBERS
    )
    return replace(phrase, but=kept) if same else phrase


def _how_many_stay(sentence: str) -> re.Match[str] | None:
    """Where the sentence tells the ``number`` of a ``noun`` that is left."""
    patterns = (_LEFT, _STAYED, _ALL_BUT, _ALL_OF_THEM_BUT, _EVERY_BUT, _KEPT)
    return next((found for each in patterns if (found := each.search(sentence))), None)


def rest_of_kind(sentence: str, selection: Selection) -> Phrase | None:
    """What "the rest" is of, where so many of a kind stay: "leave two brushes out, the rest …"."""
    match = _LEFT.search(sentence) or _STAYED.search(sentence)
    noun = match["noun"] if match else ""
    said = (Phrase(text=each, quantity="all") for each in (noun, noun.partition(" ")[0]) if each)
    return next((each for each in said if selection.possible(each)), None)


def speaks_of_rest(sentence: str) -> bool:
    """Whether "the rest" stands there for those of a kind that were not counted off."""
    return bool(_REST.search(sentence)) and not _ALL_ELSE.search(sentence)


def stays(text: str, sentence: str) -> bool:
    """Whether the sentence has these words left where they are."""
    found = words(text)
    spoken = r"\s+".join(re.escape(each) for each in found[:-1]) or re.escape(text)
    return bool(re.search(_STAYING.format(spoken), sentence, re.I))


def staying(things: Sequence[Thing], sentence: str) -> set[str]:
    """The names of what a sentence of its own says stays: "The marble can stay put."."""
    parts = [part for part in re.split(r"(?<=[.!;])\s+", sentence) if STAYS.match(part.strip())]
    said = {normal(word) for part in parts for word in words(part)}
    heads = [normal(thing.core[-1]) for thing in things if thing.core]
    return {
        thing.name
        for thing in things
        if thing.core
        and (
            set(thing.unmarked.split()) <= said
            or (normal(thing.core[-1]) in said and heads.count(normal(thing.core[-1])) == 1)
        )
    }


def means_all(phrase: Phrase, sentence: str) -> bool:
    """Whether "what you can write with" stands behind a single thing one can write with."""
    said = set(words(sentence))
    speaks = bool(said & {"what", "whatever", "everything", "anything", "all"})
    single = bool(said & {"thing", "something", "one"})
    return phrase.text.lower().startswith("thing ") and speaks and not single


_SPELT = {
    **{"single": 1, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5},
    **{"six": 6, "seven": 7, "eight": 8, "nine": 9, "ten": 10, "twelve": 12},
}
_NUMBERS: dict[str, int] = {**_SPELT, **{str(number): number for number in range(1, 13)}}
_LEFT = re.compile(
    rf"\b(?:leave|leaving|keep|keeping|spare)\s+(?:me |us |him |her |them )?(?:just |only |out )?(?P<number>{'|'.join(_NUMBERS)})\s+"
    r"(?:of (?:the|these|those|my|your)\s+)?(?P<noun>\w+(?: \w+)?)\b"
    r".*\b(?:others?|rest|remaining|remainder)\b",
    re.I,
)
_KEPT = re.compile(
    r"\b(?:leave|leaving|keep|keeping|spare|sparing)\s+(?:me |us )?(?:just |only )?(?:a )?"
    rf"(?P<number>{'|'.join(_NUMBERS)})\s+(?:of (?:the|these|those|my|your)\s+)?"
    r"(?P<noun>(?:of )?\w+)\s+(?:out|behind|aside|back|here|there|where|on the|for)\b",
    re.I,
)
"""All the jars in the crate, keeping a single one out."""
_STAYED = re.compile(
    rf"\b(?P<number>{'|'.join(_NUMBERS)})\s+(?P<noun>\w+) (?:can |should |must |is to )?(?:stays?|remains?)\b"
    r".*\b(?:others?|rest|remaining|remainder)\b",
    re.I,
)
_ALL_BUT = re.compile(
    rf"\b(?:all|every one) (?:but|except|bar) (?P<number>{'|'.join(_NUMBERS)})\s+"
    r"of (?:the|these|those|my|your|our)\s+(?P<noun>\w+(?: \w+)?)\b",
    re.I,
)
_ALL_OF_THEM_BUT = re.compile(
    r"\b(?:all|all of|every one of) (?:(?:the|these|those|my|your|our)\s+)?(?P<noun>\w+(?: \w+)?),? "
    rf"(?:but|except|bar|save) (?P<number>{'|'.join(_NUMBERS)})"
    r"(?=\s*(?:[.,;:!?)]|$)|\s+(?:on|onto|in|into|to|from|go|goes|should|can|belongs?)\b)",
    re.I,
)
_ONE = (
    r"\b(?:one|1|single|lone|each|every|either|any)\b|\b(?:an?|un[ae]?|ein\w*)(?: \w+)?(?: \w+)? {}"
)
"""What may say that one is meant: "a small pot", but not "a bit of space"."""
_REST = re.compile(
    rf"\bthe (?:rest|remainder|others|other half|(?:other|remaining) (?:ones|{'|'.join(_NUMBERS)}))\b",
    re.I,
)
_ALL_ELSE = re.compile(r"\b(?:every|any)thing\b|\ball (?:else|other)\b", re.I)
_EVERY_BUT = re.compile(
    rf"\bevery (?P<noun>\w+),? (?:but|except|bar|save) (?P<number>{'|'.join(_NUMBERS)})"
    r"(?=\s*(?:[.,;:!?)]|$)|\s+(?:on|onto|in|into|to|from|goes|should|can|belongs)\b)",
    re.I,
)
_STAYING = (
    r"\b(?:leav(?:e|ing)|keep(?:ing)?|ignor(?:e|ing)|spar(?:e|ing)|not touch(?:ing)?|don't touch)\s+"
    r"(?:only |just )?(?:the|my|your|that|this|those|these)\s+{}\b(?! and\b)(?:\s+(?!in\b|on\b|into\b|onto\b|inside\b)[\w-]+)?"
    r"\s+(?:out|behind|alone|be|there|where|as|aside|untouched|in peace)\b"
)
