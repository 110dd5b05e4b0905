"""Two clauses as one sentence: ``first put the cup in the bowl, then open the box``."""

from app.training.acting import clause
from app.training.actor import Actor
from app.training.draft import Draft
from app.training.nouns import Nouns
from app.training.putting import put
from app.training.robots import PUT, Robot
from app.training.words import Words

JOINTS = (
    "{a} and {b}",
    "{a}, then {b}",
    "{a} and then {b}",
    "{a}. then {b}",
    "{a}. {b}.",
    "first {a}, then {b}",
    "{a}; {b}",
    "{a}, and {b}",
    "{a} and after that {b}",
    "{a}. after that, {b}",
    "{a}. also {b}",
    "{a}, afterwards {b}",
    "{a} before you {b}",
    "{a} and also {b}",
    "{a}. next, {b}",
    "1. {a} 2. {b}",
    "{a}, {b}",
    "start with this: {a}. then {b}",
    "{a}. finally, {b}",
    "{a}, and when that's done, {b}",
)


def two_clauses(nouns: Nouns, _robot: Robot) -> Draft:
    """Two puts."""
    first, steps, _ = put(nouns, imperative=True)
    second, more, _ = put(nouns, imperative=True)
    return Draft(_join(nouns.words, first, second), [*steps, *more])


def verbs(nouns: Nouns, robot: Robot) -> Draft:
    """Another verb, and then a put or one verb more."""
    actor = Actor(nouns, robot)
    first, steps, _ = clause(actor)
    if robot.can(PUT) and nouns.words.chance(0.5):
        second, more, _ = put(nouns, imperative=True)
    else:
        second, more, _ = clause(actor)
    return Draft(_join(nouns.words, first, second), [*steps, *more])


def _join(words: Words, first: str, second: str) -> str:
    joint = words.choose(JOINTS)
    return joint.format(a=first.rstrip(".?!"), b=second)
