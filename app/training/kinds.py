"""The kinds of sentences, how often each is made, and how."""

from collections.abc import Callable
from typing import NamedTuple

from app.training.acting import clause
from app.training.actor import Actor
from app.training.chaining import chain, quoted
from app.training.chores import Chores
from app.training.constructions import construction
from app.training.dialogue import dialogue
from app.training.draft import Draft
from app.training.foreign import foreign
from app.training.joining import two_clauses, verbs
from app.training.noise import typed
from app.training.nouns import Nouns
from app.training.opening import around
from app.training.putting import put
from app.training.refusing import impossible
from app.training.robots import PUT, STACK, Robot, equip
from app.training.sentences import sentences
from app.training.steps import Clause
from app.training.towers import tower


class Kind(NamedTuple):
    """One kind of sentence."""

    weight: float
    make: Callable[[Nouns, Robot], Draft]


def _foreign(nouns: Nouns, robot: Robot) -> Draft:
    text, steps = foreign(nouns.words)
    for concept in {step.concept for step in steps} - {PUT, STACK}:
        equip(nouns.words, robot, concept)
    text = typed(nouns.words, text)
    return Draft(text, steps, plain=True)


def _whole(nouns: Nouns, robot: Robot) -> Draft:
    found = nouns.words.choose(sentences())
    for concept in {step.concept for step in found.steps} - {PUT, STACK}:
        equip(nouns.words, robot, concept)
    if nouns.words.chance(0.6):
        found = found.about(nouns.names.noun)
    text = found.text
    if nouns.words.chance(0.3):
        text = text.lower().rstrip(".!")
    return Draft(text, list(found.steps), plain=True)


def _chore(nouns: Nouns, _robot: Robot) -> Draft:
    text, lines, actions = Chores(nouns.words).ask()
    return Draft(text, [], lines=tuple(lines), actions=actions)


def _of_nouns(said: Callable[[Nouns], Clause]) -> Callable[[Nouns, Robot], Draft]:
    return lambda nouns, _robot: Draft(*said(nouns))


def _of_verbs(said: Callable[[Actor], Clause]) -> Callable[[Nouns, Robot], Draft]:
    return lambda nouns, robot: Draft(*said(Actor(nouns, robot)))


KINDS: dict[str, Kind] = {
    "put": Kind(32, _of_nouns(put)),
    "construction": Kind(26, construction),
    "two clauses": Kind(4, two_clauses),
    "stack": Kind(10, _of_nouns(tower)),
    "verb": Kind(11, _of_verbs(clause)),
    "verbs": Kind(4, verbs),
    "chain": Kind(9, _of_verbs(chain)),
    "quoted": Kind(2, _of_verbs(quoted)),
    "around": Kind(3, _of_verbs(around)),
    "foreign": Kind(12, _foreign),
    "impossible": Kind(6, impossible),
    "dialogue": Kind(4, dialogue),
    "sentence": Kind(60, _whole),
    "chore": Kind(34, _chore),
}
VERBAL = ("verb", "verbs", "chain", "quoted")
"""Kinds that are about a robot's other verbs, not about putting."""
