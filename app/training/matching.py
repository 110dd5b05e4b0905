"""Sentences that give each thing a place of its like, or each place so many things."""

from app.domain.program import literal
from app.training.nouns import Nouns
from app.training.numbers import SPOKEN
from app.training.said import Said, fill
from app.training.sets import class_said
from app.training.steps import Clause, put_steps
from app.training.words import ThingClass

SAME_SENTENCES = (
    "sort the {many} by {p} into the {holders}",
    "sort the {many} into the {holders} by {p}",
    "match the {many} with the {holders} by {p}",
    "match each {one} to the {holder} of the same {p}",
    "the {many} should go into the {holders} according to {p}",
    "each {one} goes with the {holder} of its {p}",
    "group the {many} by {p} in the {holders}",
    "every {one} belongs in the {holder} that has its {p}",
    "sort the {many} so that every {one} is in a {holder} of its own {p}",
    "pair the {many} up with the {holders}, matching {p}s",
    "organize the {many} into the {holders} by {p}",
    "arrange the {many} by {p} in the {holders}",
    "put the {many} and {holders} of equal {p} together: {many} into {holders}",
    "assign each {one} to the {holder} whose {p} matches",
    "distribute the {many} over the {holders} according to their {p}",
)
ASKED = frozenset({"put", "place", "give", "drop", "let", "fill", "make", "set", "serve"})
"""First words of a sentence that is an order."""


def of_its_like(nouns: Nouns) -> Clause:
    """``each block in the bowl of its colour``."""
    kind, holder, many = _places(nouns)
    spoken = nouns.rng.choice(("colour", "color", "colour", "color", "material", "size", "shape"))
    key = "same_colour" if spoken.startswith("col") and nouns.words.chance(0.3) else "same"
    preposition = _preposition(nouns, kind)
    phrase = nouns.words.say("sets", key).format(
        **{"in": preposition}, holder=holder, holders=many, property=spoken
    )
    what = nouns.sets.class_set() if nouns.words.chance(0.8) else nouns.sets.everything()
    argument = f"same({literal('colour' if spoken == 'color' else spoken)}, {literal(many)})"
    where = Said("", (argument,), forms={"in": phrase, "to": phrase, "to2": phrase}, kind=kind)
    if key == "same" and nouns.words.chance(0.2):
        found = nouns.sets.kind()
        what = class_said(found)
        text = nouns.words.choose(SAME_SENTENCES).format(
            many=found.many, one=found.one, holder=holder, holders=many, p=spoken
        )
        return text, put_steps(what, where), text.split()[0] not in {"the", "each", "every"}
    bank = [each for each in nouns.words.lists["put"]["do"] if "{h.in}" in each or "{h.to}" in each]
    template = nouns.rng.choice(bank[:8]) if nouns.words.chance(0.5) else nouns.words.choose(bank)
    return fill(template, {"x": what, "h": where}), put_steps(what, where), True


def each_place(nouns: Nouns) -> Clause:
    """``one candy in each cup``."""
    kind, holder, many = _places(nouns)
    if nouns.words.chance(0.3):
        mark = nouns.names.adjective()
        holder, many = f"{mark} {holder}", f"{mark} {many}"
    places = {"in": _preposition(nouns, kind), "holder": holder, "holders": many}
    found = nouns.sets.kind()
    count = 1
    if nouns.words.chance(0.4):
        text = _spread(nouns, found, places)
        order = text.split()[0] not in {"every", "each", "one"}
    else:
        count = nouns.rng.choice((1, 1, 1, 2, 2, 3))
        text = _so_many(nouns, found, count, places)
        order = text.split()[0] in ASKED
    counted = f", count={count}" if count > 1 else ""
    where = Said("", (f"each({literal(many)}{counted})",), kind=kind)
    return text, put_steps(class_said(found), where), order


def _spread(nouns: Nouns, found: ThingClass, places: dict[str, str]) -> str:
    template = nouns.words.say("sets", "spread")
    what = nouns.rng.choice(
        (f"the {found.many}", f"all the {found.many}", f"all {found.many}", found.many)
    )
    if "of {x}" in template:
        what = f"the {found.many}"
    return template.format(x=what, **places)


def _so_many(nouns: Nouns, found: ThingClass, count: int, places: dict[str, str]) -> str:
    first = (
        nouns.rng.choice(("one", "a", "one", "a single", "exactly one", "1"))
        if count == 1
        else nouns.rng.choice((SPOKEN[count - 1], str(count)))
    )
    if first == "a" and found.one[0] in "aeiou":
        first = "an"
    noun = found.one if count == 1 else found.many
    return nouns.words.say("sets", "one_each").format(n1=first, one1=noun, **places)


def _places(nouns: Nouns) -> tuple[str, str, str]:
    """Whether things go in or on it, what one such place is called, and what several are."""
    kind = nouns.rng.choice(("in", "in", "on"))
    holder = nouns.words.choose(nouns.words.lists["words"]["containers"][kind])
    many = f"{holder}es" if holder.endswith(("x", "ch", "sh")) else f"{holder}s"
    return kind, holder, many


def _preposition(nouns: Nouns, kind: str) -> str:
    return nouns.rng.choice(("in", "in", "into") if kind == "in" else ("on", "on", "onto"))
