"""Sentences of the goals in ``goals.json``: templates with slots, and a sketch with the same slots."""

from dataclasses import replace
from typing import TYPE_CHECKING

from app.training.draft import Draft
from app.training.nouns import Nouns
from app.training.numbers import number
from app.training.robots import Robot
from app.training.said import Said, fill, one
from app.training.sets import class_said
from app.training.steps import read_steps
from app.training.words import ThingClass

if TYPE_CHECKING:
    from collections.abc import Callable


def construction(nouns: Nouns, _robot: Robot) -> Draft:
    """A sentence of one of the goals, with its steps."""
    entries = nouns.words.lists["goals"]
    entry = nouns.rng.choices(entries, [each["weight"] for each in entries])[0]
    made = _slots(nouns, entry["slots"])
    text = fill(nouns.words.choose(entry["say"]), made)
    return Draft(
        text,
        [step for line in entry["sketch"] for step in read_steps(line, made)],
        order=text.split()[0] in {"put", "move", "sort", "place", "take"},
        plain=entry["name"] == "injection",
    )


def _slots(nouns: Nouns, kinds: dict[str, str]) -> dict[str, Said]:
    """Every slot of a construction, classes first."""
    made: dict[str, Said] = {}
    classes: dict[str, ThingClass] = {}
    for name, kind in kinds.items():
        if kind == "class":
            classes[name] = nouns.sets.kind()
            made[name] = class_said(classes[name])
    for name, kind in kinds.items():
        if kind != "class":
            made[name] = _slot(nouns, kind, classes)
    for name, form in (("n", "nmany"), ("m", "mmany")):
        if name in made and not made[name].plural:
            for key, found in classes.items():
                made[key] = replace(made[key], forms={**made[key].forms, form: found.one})
    return made


def _slot(nouns: Nouns, kind: str, classes: dict[str, ThingClass]) -> Said:
    """What a construction's slot of this kind is filled with."""
    if kind.startswith("member:"):
        return nouns.leaving.member(classes[kind.removeprefix("member:")])
    makers: dict[str, Callable[[], Said]] = {
        "thing": nouns.thing,
        "movable": nouns.movable,
        "holder": nouns.holder,
        "number": lambda: number(nouns.words),
        "members": nouns.leaving.left_out,
        "indirect": lambda: _wish(nouns),
        "mass": nouns.sets.mass,
        "box": nouns.holders.box,
        "injection": lambda: Said(nouns.words.say("speech", "injections"), ()),
    }
    return makers[kind]()


def _wish(nouns: Nouns) -> Said:
    phrase = nouns.rng.choice(list(nouns.words.lists["speech"]["wishes"]))
    wish = nouns.words.say("speech", "wishes", phrase)
    text = phrase.replace(
        "thing", nouns.rng.choice(("something", "something", "the thing", "a thing")), 1
    )
    because = nouns.words.say("speech", "because")
    return one(text, phrase, wish=wish, because=because)
