"""Clauses for verbs that do other things than put: opening, pouring, washing, what nobody has heard of."""

from app.training.actor import Actor
from app.training.concepts import known
from app.training.everyday import pair, plain
from app.training.inventing import made_up
from app.training.robots import clashes
from app.training.steps import Clause

READY = ("PUSH", "OPEN", "CLOSE", "LEFTOF", "PLACEAT", "SWITCHON", "POUR")
"""A robot that can do one of these is mostly asked for what it can."""


def clause(actor: Actor) -> Clause:
    """One request for a verb, which the robot is given if it has not got it."""
    draw = actor.rng.random()
    if any(map(actor.robot.can, READY)) and actor.words.chance(0.6):
        return known(actor, _concept(actor))
    if draw < 0.22:
        return plain(actor)
    if draw < 0.36:
        return pair(actor)
    if draw < 0.50:
        return made_up(actor)
    return known(actor, _concept(actor))


def _concept(actor: Actor) -> str:
    names = list(actor.words.lists["verbs"]["concepts"])
    own = [each for each in actor.robot.verbs if each in names]
    if own and actor.words.chance(0.5):
        return actor.rng.choice(own)
    for _ in range(20):
        name = actor.rng.choice(names)
        if actor.robot.can(name) or not clashes(actor.robot, name):
            return name
    return "OPEN"
