"""Answers to a question in one's own words: "the blue one please" → the sentence that was asked about, made clear."""

import re
from collections.abc import Sequence
from dataclasses import replace

from app.domain.errors import TaskDeclined
from app.domain.planner import Turn
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.correcting import correction
from app.programs.sketches.dialogue import calls_of
from app.programs.sketches.others import other_named
from app.programs.sketches.rereading import ORDERING
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing, listed

_FILLER = word_list("answer filler")
"""Words of an answer that decide nothing."""
_ANY = frozenset(("either", "any", "anyone", "whichever", "whatever"))
_ALL_THE_SAME = re.compile(
    r"\b(?:(?:doesn't|does not|don't|do not) (?:really )?(?:matter|mind|care)|no preference|"
    r"all the same|you (?:choose|decide|pick)|up to you)\b",
    re.I,
)
_PLACES = {
    "first": 0, "former": 0, "1": 0, "1st": 0, "second": 1, "2": 1, "2nd": 1, "third": 2, "3": 2,
    "3rd": 2, "fourth": 3, "4": 3, "last": -1, "latter": -1,
}  # fmt: skip
"""Where in the question a choice stands."""
MOST_WORDS = 4
"""That an answer is made of, besides filler; more is a sentence of its own."""


def heard(sentence: str, history: Sequence[Turn], things: Sequence[Thing]) -> str:
    """What the sentence says after the turns before, whose own sentences are clear.

    An answer to their last question is the choice that it makes, a correction is the sentence
    before put right, and what is said of "the other one" is said by name.

    Raises:
        TaskDeclined: it answers, but several of the choices fit: the same question again.
    """
    if not history:
        return sentence
    if chosen := _chosen(sentence, history[-1], things):
        return chosen
    return correction(sentence, history[-1].instruction, things) or other_named(
        sentence, history, things
    )


def clear_history(history: Sequence[Turn], things: Sequence[Thing]) -> tuple[Turn, ...]:
    """The turns with what their sentences say, each after those before it."""
    clear: list[Turn] = []
    for turn in history:
        try:
            clear.append(replace(turn, instruction=heard(turn.instruction, clear, things)))
        except TaskDeclined:
            clear.append(turn)
    return tuple(clear)


def done(history: Sequence[Turn]) -> tuple[Turn, ...]:
    """The turns that came to a plan.

    What was declined was not done, and what it asked for is not to be done by and by.
    """
    return tuple(turn for turn in history if calls_of(turn.program))


def _chosen(sentence: str, asked: Turn, things: Sequence[Thing]) -> str | None:
    """The choice of the question that the sentence answers with; None where it is no answer."""
    choices = asked.choices
    if not choices or sentence in choices:
        return sentence if choices else None
    if _ALL_THE_SAME.search(sentence) and len(words(sentence)) <= 2 * MOST_WORDS:
        return choices[0]
    said = [each for each in words(sentence) if each not in _FILLER]
    if not 0 < len(said) <= MOST_WORDS or set(said) & ORDERING:
        return None
    if set(said) & _ANY:
        return choices[0]
    place = _PLACES.get(said[0]) if len(said) == 1 or said[1:] == ["choice"] else None
    if place is not None and place < len(choices):
        return choices[place]
    return _named(sentence, " ".join(said), asked, things)


def _named(sentence: str, said: str, asked: Turn, things: Sequence[Thing]) -> str | None:
    """The choice that the words name, among those of the question alone."""
    options = _options(asked.choices, things)
    if len(options) < len(asked.choices):
        return None
    selection = Selection(list(options), frozenset(), sentence)
    negated = said.startswith("not ") and len(options) == 2
    phrase = Phrase(text=said.removeprefix("not "))
    if not selection.possible(phrase):
        return None
    try:
        chosen = selection.one(phrase).things[0]
    except TaskDeclined as declined:
        question = asked.outcome or f"Which one: {listed([t.name for t in options], 'or')}?"
        raise TaskDeclined(
            declined.reason, kind="ambiguous", question=question, choices=asked.choices
        ) from declined
    left = [thing for thing in options if thing is not chosen]
    return options[left[0] if negated else chosen]


def _options(choices: Sequence[str], things: Sequence[Thing]) -> dict[Thing, str]:
    """The thing that each choice names and that not all of them do."""
    spoken = [set(_spoken(choice, things)) for choice in choices]
    common = set[Thing].intersection(*spoken)
    own = [named - common for named in spoken]
    return {
        named.pop(): choice for named, choice in zip(own, choices, strict=True) if len(named) == 1
    }


def _spoken(choice: str, things: Sequence[Thing]) -> list[Thing]:
    """The things that the choice says by their names; of "coffee mug" not the mug."""
    text, found = choice.lower(), list[Thing]()
    for thing in sorted(things, key=lambda each: -len(each.name)):
        name = rf"(?<!\w){re.escape(thing.name.lower())}(?!\w)"
        if re.search(name, text):
            found.append(thing)
            text = re.sub(name, " ", text)
    return found
