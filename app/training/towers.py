"""Sentences that ask for a tower, named piece by piece or as a set."""

import itertools

from app.domain.program import literal
from app.training.nouns import Nouns
from app.training.robots import STACK
from app.training.said import Said, fill, one
from app.training.steps import Clause, Step, put_steps

AS_A_SET = ("largest_first", "smallest_first", "left_to_right", "right_to_left", "any_order")
"""Ways of asking in which the pieces are a class, in an order."""
ORDERS = frozenset(("stack", "build", "make", "pile", "put", "place", "set", "arrange", "use"))
"""First words of a sentence that is an order."""


def tower(nouns: Nouns) -> Clause:
    """A tower, named piece by piece or as a set."""
    bank = nouns.words.lists["stacks"]
    kind = nouns.rng.choices(list(bank), (18, 14, 14, 5, 4, 4, 6, 10, 8, 3, 3, 8))[0]
    if kind in AS_A_SET:
        found = nouns.sets.kind()
        text = nouns.words.choose(bank[kind]).format(many=found.many, one=found.one)
        taken = "" if kind == "any_order" else f", order={literal(kind.replace('_', ' '))}"
        argument = f"all({literal(found.many)}{taken})"
        order = text.split()[0] in ORDERS
        return text, [Step(STACK, {"x": argument, "y": "previous"}, on=True)], order
    count = {"two": 2, "on_holder": 2, "four_up": 4, "four_down": 4}.get(kind, 3)
    pieces = _pieces(nouns, count)
    slots = dict(zip("abcd", pieces, strict=False))
    steps: list[Step] = []
    if kind == "on_holder":
        slots["h"] = nouns.holder()
        steps += put_steps(pieces[0], slots["h"])
    for lower, upper in itertools.pairwise(pieces):
        steps.append(Step(STACK, {"x": upper.arguments[0], "y": lower.arguments[0]}, on=True))
    if kind == "two":
        steps = [Step(STACK, {"x": pieces[0].arguments[0], "y": pieces[1].arguments[0]}, on=True)]
    text = fill(nouns.words.choose(bank[kind]), slots)
    return text, steps, "tower of two" in text and kind == "two"


def _pieces(nouns: Nouns, count: int) -> list[Said]:
    """What the tower is built of: often of one kind in different colours, by the colour alone."""
    draw = nouns.rng.random()
    if draw < 0.3:
        return [nouns.names.bare() for _ in range(count)]
    lists = nouns.words.lists["words"]
    noun = nouns.words.choose([*lists["variants"], "block", "block", "cube"])
    marks = (
        nouns.rng.sample([*lists["colours"][:8], *lists["materials"][:4]], count)
        if draw < 0.85
        else nouns.rng.sample(["small", "medium", "large", "tiny"], count)
    )
    style = nouns.rng.random()
    if style < 0.6:
        return [one(f"the {mark} {noun}", f"{mark} {noun}") for mark in marks]
    if style < 0.8:
        first = one(f"the {marks[0]} {noun}", f"{marks[0]} {noun}")
        return (
            [first, *(one(f"the {mark} one", f"{mark} {noun}") for mark in marks[1:])]
            if count == 2
            else [one(f"the {mark} one", f"{mark} one") for mark in marks]
        )
    article = nouns.rng.choice(("", "", "the "))
    return [one(f"{article}{mark}", f"{mark} one") for mark in marks]
