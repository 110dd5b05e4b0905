"""Clauses that open a thing before a put, or close it after."""

from app.training.actor import Actor
from app.training.robots import PUT, equip
from app.training.said import fill, one
from app.training.steps import Clause, Step, put_steps

AROUND = {
    "open put": (
        "open {h} and put {x} {h.there}",
        "open {h}, then put {x} {h.there}",
        "put {x} {h.in}, but open {h} first",
        "open up {h} and place {x} {h.there}",
        "open {h}. put {x} {h.there}.",
        "{h} is closed. open it and put {x} {h.there}",
        "before putting {x} {h.in}, open {h}",
        "after opening {h}, put {x} {h.in}",
        "open {h} so that you can put {x} {h.there}",
        "first open {h}, then put {x} {h.in}",
    ),
    "put close": (
        "put {x} {h.in} and close {h}",
        "put {x} {h.in}, then close it",
        "put {x} {h.in} and shut it",
        "place {x} {h.in} and close it afterwards",
        "put {x} {h.in}. close {h}.",
        "after putting {x} {h.in}, close it",
        "close {h} after you have put {x} {h.there}",
        "once {x} {x?is|are} {h.in}, shut {h}",
        "store {x} {h.in} and then close {h}",
        "put {x} {h.in} and don't leave it open",
    ),
    "open put close": (
        "open {h}, put {x} {h.there} and close it",
        "open {h}, put {x} {h.there}, and close it again",
        "put {x} {h.in}; open it first and close it afterwards",
        "open {h}. put {x} {h.there}. shut {h}.",
        "open {h}, place {x} {h.in}, then shut it again",
    ),
}


def around(actor: Actor) -> Clause:
    """Opening and closing about a put."""
    words, nouns = actor.words, actor.nouns
    kind = words.rng.choice(list(AROUND))
    what = nouns.movable()
    noun = words.choose(words.lists["speech"]["openables"][:20])
    where = nouns.holders.placed(nouns.holders.named(noun), "in")
    if "all(" in where.arguments[0]:
        where = nouns.holders.placed(one(f"the {noun}", noun), "in")
    steps: list[Step] = []
    for part in kind.split():
        concept = part.upper()
        if concept == PUT:
            steps += put_steps(what, where)
        else:
            equip(words, actor.robot, concept)
            steps.append(Step(concept, {"x": where.arguments[0]}))
    return fill(words.choose(AROUND[kind]), {"x": what, "h": where}), steps, True
