"""Clauses for verbs of everyday language: ``wash the cup``, ``dry the cup with the towel``."""

import re

from app.training.actor import PARAMETERS, Actor
from app.training.concepts import known, steps_of
from app.training.said import fill
from app.training.steps import Clause, Step

_MANY = {"is": "are", "needs": "need", "hasn't": "haven't", "isn't": "aren't"}


def plain(actor: Actor) -> Clause:
    """A verb of everyday language with one object."""
    stem, past, present = actor.words.say("verbs", "plain").split("|")
    concept = f"plain {stem}"
    if not actor.robot.can(concept):
        name = actor.rng.choice(
            (stem, stem, f"{stem}_object", f"{stem}_item", f"do_{stem}", stem.capitalize())
        )
        actor.robot.add(concept, f"{name}(x:{actor.rng.choice(PARAMETERS)})")
    if not actor.robot.can(concept):
        return known(actor, "OPEN")
    what = actor.nouns.movable() if actor.words.chance(0.5) else actor.nouns.thing()
    template = actor.words.say("verbs", "plain_say")
    if what.plural:
        template = re.sub(
            r"\{x\} (is|needs|hasn't|isn't)\b", lambda m: f"{{x}} {_MANY[m[1]]}", template
        )
        template = template.replace(" it", " them") if template.endswith(" it") else template
    text = template.replace("{v}", stem).replace("{ved}", past).replace("{ving}", present)
    steps = [Step(concept, {"x": each}) for each in what.arguments]
    return fill(text, {"x": what}), steps, text.split()[0] in {stem, "take", "go"}


def pair(actor: Actor) -> Clause:
    """A verb with a second object: ``dry the cup with the towel``."""
    stem, preposition, role = actor.words.say("verbs", "pair").split("|")
    joined = preposition.replace(" ", "_")
    name = actor.rng.choice((stem, f"{stem}_{joined}", f"{stem}_{joined}", f"{stem}_object"))
    first, swapped = (
        actor.rng.choice(("obj", "item", "thing", "object", "obj1")),
        actor.words.chance(0.3),
    )
    pairs = [f"x:{first}", f"y:{role}"]
    concept = f"pair {stem}"
    if not actor.robot.add(concept, f"{name}({', '.join(pairs[::-1] if swapped else pairs)})"):
        return known(actor, "CLOSE")
    what, other = actor.nouns.thing(), actor.nouns.thing()
    templates = [f"{stem} {{x}} {preposition} {{y}}"] * 4
    if preposition == "with":
        templates += [
            f"use {{y}} to {stem} {{x}}",
            f"take {{y}} and {stem} {{x}} with it",
            f"with {{y}}, {stem} {{x}}",
            f"{stem} {{x}} using {{y}}",
            f"{stem} {{x}} by means of {{y}}",
        ]
    slots = {"x": what, "y": other}
    return fill(actor.rng.choice(templates), slots), steps_of(concept, slots), True
