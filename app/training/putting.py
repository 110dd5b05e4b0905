"""Sentences that ask for things to be put somewhere, some of them with what is left out told after."""

from app.domain.program import literal
from app.training.matching import each_place, of_its_like
from app.training.nouns import Nouns
from app.training.said import Said, fill
from app.training.sets import class_said
from app.training.steps import Clause, put_steps


def put(nouns: Nouns, *, imperative: bool = False) -> Clause:
    """Things to a place, as an order or as a wish."""
    draw = nouns.rng.random()
    if draw < 0.025:
        return _keep_only(nouns)
    if draw < 0.10:
        return _put_but(nouns)
    if draw < 0.15:
        return of_its_like(nouns)
    if draw < 0.20:
        return each_place(nouns)
    what, where = nouns.movable(), nouns.holder()
    order = imperative or nouns.words.chance(0.5)
    bank = nouns.words.lists["put"]["do" if order else "say"]
    if order and what.plural and nouns.words.chance(0.25):
        bank = nouns.words.lists["put"]["gather"]
    simple = nouns.words.chance(0.25) and order
    template = (
        nouns.rng.choice(bank[:6])
        if simple and bank[0].startswith("put")
        else nouns.words.choose(bank)
    )
    steps = put_steps(what, where)
    return fill(template, {"x": what, "h": where}), steps, order


def _put_but(nouns: Nouns) -> Clause:
    """A set, and after it or before it what is left out."""
    where = nouns.holder()
    if nouns.words.chance(0.4):
        whole, phrase, left = nouns.sets.everything(), "things", nouns.leaving.left_out()
    else:
        found = nouns.sets.kind()
        text = nouns.sets.told("all", found)
        whole = Said(
            text, (), plural="every " not in text and "each " not in text and "any " not in text
        )
        phrase, left = found.many, nouns.leaving.member(found)
    order = nouns.words.chance(0.75)
    template = nouns.words.choose(
        nouns.words.lists["put"]["do" if order else "say"][: None if order else 40]
    )
    if nouns.words.chance(0.3):
        template = nouns.rng.choice(nouns.words.lists["put"]["do"][:8])
    clause = fill(template, {"x": whole, "h": where})
    around = "except_after" if nouns.words.chance(0.8) else "except_before"
    sentence = fill(nouns.words.say("sets", around), {"c": Said(clause, ()), "e": left})
    argument = f"all({literal(phrase)}, but={left.words})"
    return sentence, put_steps(Said("", (argument,)), where), around == "except_after" and order


def _keep_only(nouns: Nouns) -> Clause:
    """What stays is named, and the rest goes."""
    where = nouns.holder()
    if nouns.words.chance(0.6):
        left = nouns.leaving.left_out()
        argument = f"all('things', but={left.words})"
        text = fill(nouns.words.say("sets", "keep_only"), {"e": left, "h": where})
    else:
        found = nouns.sets.kind()
        left = nouns.leaving.member(found)
        argument = f"all({literal(found.many)}, but={left.words})"
        slots = {"e": left, "h": where, "s": class_said(found)}
        text = fill(nouns.words.say("sets", "keep_class"), slots)
    return (
        text,
        put_steps(Said("", (argument,)), where),
        text.split()[0] in {"keep", "leave", "clear", "put"},
    )
