"""The same in German, French, Spanish, Italian, Portuguese, Dutch and Chinese: sketches stay English."""

from app.domain.program import literal
from app.training.robots import PUT, STACK
from app.training.steps import Step
from app.training.words import Words

OPEN, CLOSE = "OPEN", "CLOSE"


def foreign(words: Words) -> tuple[str, list[Step]]:  # noqa: C901 (a case for each construction)
    """A sentence of one of the languages, with its steps."""
    lists = words.lists["foreign"]
    language = words.rng.choices(lists["languages"], (5, 5, 5, 5, 5, 5, 3))[0]
    column = 1 + lists["languages"].index(language)

    def drawn(kind: str, avoid: str = "") -> tuple[str, str]:
        while True:
            cells = words.rng.choice(lists[kind]).split("|")
            if cells[0] != avoid:
                return cells[0], cells[column]

    kind = words.rng.choices(
        ("put", "two", "both", "but", "stack", "open", "close"), (10, 3, 2, 3, 2, 1, 1)
    )[0]
    template = words.choose(lists[kind][language])
    if kind in ("open", "close"):
        name, said = drawn("openables")
        return template.format(o=said), [Step(kind.upper(), {"x": literal(name)})]
    where = drawn("holders")
    if kind == "but":
        whole, left = drawn("sets"), drawn("except")
        argument = f"all({literal(whole[0])}, but={literal(left[0])})"
        text = template.format(s=whole[1], e=left[1], h=where[1])
        return text, [_put(argument, where[0])]
    if kind == "put" and words.chance(0.3):
        whole = drawn("sets")
        return template.format(x=whole[1], h=where[1]), [
            _put(f"all({literal(whole[0])})", where[0])
        ]
    first = drawn("things")
    second = drawn("things", first[0])
    other = drawn("holders", where[0])
    text = template.format(x=first[1], y=second[1], h=where[1], k=other[1])
    if kind == "stack":
        return text, [Step(STACK, {"x": literal(first[0]), "y": literal(second[0])}, on=True)]
    steps = [_put(literal(first[0]), where[0])]
    if kind == "two":
        steps.append(_put(literal(second[0]), other[0]))
    elif kind == "both":
        steps.append(_put(literal(second[0]), where[0]))
    return text, steps


ON = frozenset({"plate", "tray", "shelf", "towel", "cutting board"})


def _put(argument: str, where: str) -> Step:
    return Step(PUT, {"x": argument, "y": literal(where)}, on=where in ON)
