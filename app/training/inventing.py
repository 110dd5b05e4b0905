"""Clauses for verbs that nobody has heard of."""

from app.training.actor import PARAMETERS, Actor
from app.training.concepts import known, steps_of
from app.training.robots import invented
from app.training.said import fill
from app.training.steps import Clause

_SECOND = (
    "tool",
    "target",
    "obj2",
    "other",
    "with_what",
    "goal",
    "instrument",
    "to",
    "place",
    "y",
    "partner",
    "source",
)
INVENTED_ONE = (
    "{v} {x}",
    "{v} {x}",
    "please {v} {x}",
    "can you {v} {x}?",
    "i want you to {v} {x}",
    "{x} should be {v}ed",
    "go and {v} {x}",
    "let's {v} {x}",
    "{v} {x} now",
    "take {x} and {v} it",
    "{v} {x} for me",
    "make sure to {v} {x}",
)
INVENTED_TWO = (
    "{v} {x} {p} {y}",
    "{v} {x} {p} {y}",
    "please {v} {x} {p} {y}",
    "i'd like you to {v} {x} {p} {y}",
    "could you {v} {x} {p} {y}?",
    "go {v} {x} {p} {y}",
)
PREPOSITIONS = (
    "with",
    "to",
    "into",
    "onto",
    "at",
    "for",
    "against",
    "around",
    "from",
    "over",
    "under",
    "through",
)


def made_up(actor: Actor) -> Clause:
    """A verb of no language, with one or two objects."""
    verb, two = invented(actor.rng), actor.words.chance(0.5)
    name = actor.rng.choice((verb, verb, f"{verb}_it", f"do_{verb}", f"{verb}_object"))
    pairs = [f"x:{actor.rng.choice(PARAMETERS)}"]
    if two:
        pairs.append(f"y:{actor.rng.choice(_SECOND)}")
    if two and pairs[0][2:] == pairs[1][2:]:
        pairs[1] += "2"
    if two and actor.words.chance(0.15):
        pairs.reverse()
    if not actor.robot.add(f"made {verb}", f"{name}({', '.join(pairs)})"):
        return known(actor, "OPEN")
    slots = (
        {"x": actor.nouns.thing(), "y": actor.nouns.thing()}
        if two
        else {"x": actor.nouns.movable()}
    )
    template = actor.rng.choice(INVENTED_TWO if two else INVENTED_ONE)
    preposition = actor.rng.choice(PREPOSITIONS)
    if two and pairs[0].startswith("y:"):
        preposition = "with"
    text = template.replace("{v}", verb).replace("{p}", preposition)
    return fill(text, slots), steps_of(f"made {verb}", slots), text.startswith(verb)
