"""Clauses that join a robot's verbs: one after the other, about the same thing, one and not another."""

from dataclasses import dataclass

from app.domain.program import literal
from app.training.actor import Actor
from app.training.everyday import plain
from app.training.said import Said, fill
from app.training.steps import Clause, Step

SECOND = 0.35
"""How often a joined verb has a second object."""


@dataclass(frozen=True, slots=True)
class Spoken:
    """A verb as sentences bend it, and the concept the robot has for it."""

    stem: str
    past: str
    present: str
    concept: str

    def bent(self, template: str, place: str) -> str:
        """The template with ``{v1}``, ``{v1ed}`` and ``{v1ing}`` in place."""
        for ending, word in (("", self.stem), ("ed", self.past), ("ing", self.present)):
            template = template.replace(f"{{v{place}{ending}}}", word)
        return template


def chain(actor: Actor) -> Clause:
    """Two verbs in one sentence."""
    draw = actor.rng.random()
    if draw < SECOND:
        return _given(actor)
    first, second = _spoken(actor), _spoken(actor)
    if draw < 0.62:
        kind = "same"
    elif draw < 0.78:
        kind = "different"
    else:
        kind = "not" if draw < 0.9 else "several"
    template = actor.words.say("verbs", "chains", kind)
    x, y = actor.nouns.thing(), actor.nouns.thing()
    text = second.bent(first.bent(template, "1"), "2")
    steps = _steps(first, x)
    if kind == "same":
        steps += _steps(second, x)
    elif kind == "different":
        steps += _steps(second, y)
    elif kind == "several":
        steps = _several(template, first, x, y)
    return fill(text, {"x": x, "y": y}), steps, text.startswith(first.stem)


def _several(template: str, verb: Spoken, x: Said, y: Said) -> list[Step]:
    """In the order they are done in: "after" names the later thing first."""
    turned = template.find("{y}") < template.find("{x}") and "after" not in template
    return [step for said in ((y, x) if turned else (x, y)) for step in _steps(verb, said)]


def _given(actor: Actor) -> Clause:
    """One verb, and then one with a second object: "rinse the cup and dry it with the towel"."""
    first = _spoken(actor)
    stem, preposition, role = actor.words.say("verbs", "pair").split("|")
    concept = f"pair {stem}"
    x, y = actor.nouns.thing(), actor.nouns.thing()
    swapped = actor.words.chance(0.2)
    pairs = ["x:" + actor.rng.choice(("obj", "item", "thing", "what")), f"y:{role}"]
    name = actor.rng.choice((stem, f"{stem}_{preposition.replace(' ', '_')}"))
    if not actor.robot.add(concept, f"{name}({', '.join(pairs[::-1] if swapped else pairs)})"):
        return plain(actor)
    template = actor.words.say("verbs", "chains", "given")
    told_first = template.startswith("{p}")
    if told_first:
        template = template.replace("{x}", "{x.it}")
    between = f"{stem} {x.text if told_first else x.form('it')} {preposition}"
    text = first.bent(template.replace("{p}", between), "1")
    steps = [*_steps(first, x), Step(concept, {"x": x.arguments[0], "y": y.arguments[0]})]
    return fill(text, {"x": x, "y": y}), steps, text.startswith(first.stem)


def _spoken(actor: Actor) -> Spoken:
    """A verb of everyday language that the robot is given, unless it has it."""
    while True:
        stem, past, present = actor.words.say("verbs", "plain").split("|")
        spoken = Spoken(stem, past, present, f"plain {stem}")
        parameter = actor.rng.choice(("obj", "item", "thing", "o", "part", "target", "what", "x"))
        name = actor.rng.choice((stem, stem, stem, f"{stem}_object", f"do_{stem}"))
        if not actor.robot.can(spoken.concept) and actor.robot.add(
            spoken.concept, f"{name}(x:{parameter})"
        ):
            return spoken


def _steps(verb: Spoken, said: Said) -> list[Step]:
    return [Step(verb.concept, {"x": each}) for each in said.arguments]


def quoted(actor: Actor) -> Clause:
    """A verb that takes a word of its own beside the thing: ``cut('bread', 'crosswise')``."""
    entry = actor.words.say("verbs", "worded")
    word = actor.words.choose(entry["words"])
    concept = f"worded {entry['name']}"
    if not actor.robot.add(concept, actor.words.choose(entry["names"])):
        return plain(actor)
    x = actor.nouns.thing()
    slots = {"x": x, "w": Said(word, (literal(word),))}
    text = fill(actor.words.choose(entry["say"]), slots)
    steps = [Step(concept, {"x": each, "y": literal(word)}) for each in x.arguments]
    return text, steps, True
