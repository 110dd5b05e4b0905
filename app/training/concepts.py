"""Clauses for the verbs of ``verbs.json``, each with its own ways of asking."""

from app.training.actor import Actor
from app.training.numbers import figure
from app.training.objects import verb_object
from app.training.robots import equip
from app.training.said import Said, fill
from app.training.steps import Clause, Step


def known(actor: Actor, concept: str) -> Clause:
    """A clause for this concept."""
    entry = actor.words.lists["verbs"]["concepts"][concept]
    equip(actor.words, actor.robot, concept)
    full = "full" in entry and actor.words.chance(0.35)
    template = actor.words.choose(entry["full" if full else "say"])
    slots = {"x": verb_object(actor.nouns, entry.get("of", "thing"))}
    if "to" in entry:
        slots["y"] = verb_object(actor.nouns, entry["to"])
    for name in "nm":
        slots[name] = figure(actor.rng)
    if "{v}" in template:
        template = template.replace("{v}", actor.robot.verbs[concept].name.replace("_", " "))
    steps = steps_of(concept, slots)
    return fill(template, slots), steps, not full


def steps_of(concept: str, slots: dict[str, Said]) -> list[Step]:
    """One for each thing that ``x`` names, with the second object and the numbers."""
    several = slots["x"].arguments or ("",)
    second = slots["y"].arguments[0] if "y" in slots and slots["y"].arguments else ""
    numbers = {name: slots[name].forms["digit"] for name in "nm" if name in slots}
    return [Step(concept, {"x": each, "y": second, **numbers}) for each in several]
