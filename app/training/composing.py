"""Sentences made of clauses, each with the steps that do it."""

import itertools
import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from app.domain.program import literal
from app.training.nouns import Nouns
from app.training.numbers import SPOKEN, number
from app.training.robots import PUT, STACK
from app.training.said import Said, arguments, fill, one
from app.training.sets import class_said
from app.training.words import ThingClass, Words

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

Given = dict[str, str]
"""A verb's arguments by their role."""


@dataclass(frozen=True, slots=True)
class Step:
    """A concept done with arguments, before the robot's own verb stands for it."""

    concept: str
    given: Given
    on: bool = False
    """Whether the place is something to put things on."""


class Composer:
    """Somebody who asks for things."""

    def __init__(self, words: Words, *, familiar: bool = False) -> None:
        self.words = words
        self.rng = words.rng
        self.nouns = Nouns(words, familiar=familiar)

    def slot(self, kind: str, classes: dict[str, ThingClass]) -> Said:
        """What a construction's slot of this kind is filled with."""
        if kind.startswith("member:"):
            return self.nouns.leaving.member(classes[kind.removeprefix("member:")])
        makers: dict[str, Callable[[], Said]] = {
            "thing": self.nouns.thing,
            "movable": self.nouns.movable,
            "holder": self.nouns.holder,
            "number": lambda: number(self.words),
            "members": self.nouns.leaving.left_out,
            "indirect": self._wish,
            "mass": self.nouns.sets.mass,
            "box": self.nouns.holders.box,
            "injection": self._injection,
        }
        return makers[kind]()

    def slots(self, kinds: dict[str, str]) -> dict[str, Said]:
        """Every slot of a construction, classes first."""
        made: dict[str, Said] = {}
        classes: dict[str, ThingClass] = {}
        for name, kind in kinds.items():
            if kind == "class":
                classes[name] = self.nouns.sets.kind()
                made[name] = class_said(classes[name])
        for name, kind in kinds.items():
            if kind != "class":
                made[name] = self.slot(kind, classes)
        for name, form in (("n", "nmany"), ("m", "mmany")):
            if name in made and not made[name].plural:
                for key, found in classes.items():
                    made[key] = replace(made[key], forms={**made[key].forms, form: found.one})
        return made

    def constructed(self, entry: dict) -> tuple[str, list[Step]]:
        """A sentence of a construction, with its steps."""
        made = self.slots(entry["slots"])
        sentence = fill(self.words.choose(entry["say"]), made)
        return sentence, [step for line in entry["sketch"] for step in read_steps(line, made)]

    def _wish(self) -> Said:
        phrase = self.rng.choice(list(self.words.lists["speech"]["wishes"]))
        wish = self.words.say("speech", "wishes", phrase)
        text = phrase.replace(
            "thing", self.rng.choice(("something", "something", "the thing", "a thing")), 1
        )
        because = self.words.say("speech", "because")
        return one(text, phrase, wish=wish, because=because)

    def _injection(self) -> Said:
        return Said(self.words.say("speech", "injections"), ())

    # Clauses about putting

    def put(self, *, imperative: bool = False) -> tuple[str, list[Step], bool]:
        """Text, steps, and whether it is an order (which may be wrapped in courtesies)."""
        nouns, draw = self.nouns, self.rng.random()
        if draw < 0.025:
            return self.keep_only()
        if draw < 0.10:
            return self.put_but()
        if draw < 0.15:
            return self.put_same()
        if draw < 0.20:
            return self.put_each()
        what, where = nouns.movable(), nouns.holder()
        order = imperative or self.words.chance(0.5)
        bank = self.words.lists["put"]["do" if order else "say"]
        if order and what.plural and self.words.chance(0.25):
            bank = self.words.lists["put"]["gather"]
        simple = self.words.chance(0.25) and order
        template = (
            self.rng.choice(bank[:6])
            if simple and bank[0].startswith("put")
            else self.words.choose(bank)
        )
        steps = put_steps(what, where)
        return fill(template, {"x": what, "h": where}), steps, order

    def put_but(self) -> tuple[str, list[Step], bool]:
        """A set, and after it or before it what is left out."""
        nouns = self.nouns
        where = nouns.holder()
        if self.words.chance(0.4):
            whole, phrase, left = nouns.sets.everything(), "things", nouns.leaving.left_out()
        else:
            found = nouns.sets.kind()
            text = nouns.sets.told("all", found)
            whole = Said(
                text, (), plural="every " not in text and "each " not in text and "any " not in text
            )
            phrase, left = found.many, nouns.leaving.member(found)
        order = self.words.chance(0.75)
        template = self.words.choose(
            self.words.lists["put"]["do" if order else "say"][: None if order else 40]
        )
        if self.words.chance(0.3):
            template = self.rng.choice(self.words.lists["put"]["do"][:8])
        clause = fill(template, {"x": whole, "h": where})
        around = "except_after" if self.words.chance(0.8) else "except_before"
        sentence = fill(self.words.say("sets", around), {"c": Said(clause, ()), "e": left})
        argument = f"all({literal(phrase)}, but={left.words})"
        return sentence, put_steps(Said("", (argument,)), where), around == "except_after" and order

    def keep_only(self) -> tuple[str, list[Step], bool]:
        """What stays is named, and the rest goes."""
        where = self.nouns.holder()
        if self.words.chance(0.6):
            left = self.nouns.leaving.left_out()
            argument = f"all('things', but={left.words})"
            text = fill(self.words.say("sets", "keep_only"), {"e": left, "h": where})
        else:
            found = self.nouns.sets.kind()
            left = self.nouns.leaving.member(found)
            argument = f"all({literal(found.many)}, but={left.words})"
            slots = {"e": left, "h": where, "s": class_said(found)}
            text = fill(self.words.say("sets", "keep_class"), slots)
        return (
            text,
            put_steps(Said("", (argument,)), where),
            text.split()[0] in {"keep", "leave", "clear", "put"},
        )

    def put_same(self) -> tuple[str, list[Step], bool]:
        """``each block in the bowl of its colour``."""
        nouns = self.nouns
        kind, holder, preposition = self.rng.choice(("in", "in", "on")), "", ""
        holder = self.words.choose(self.words.lists["words"]["containers"][kind])
        spoken = self.rng.choice(
            ("colour", "color", "colour", "color", "material", "size", "shape")
        )
        key = "same_colour" if spoken.startswith("col") and self.words.chance(0.3) else "same"
        many = f"{holder}es" if holder.endswith(("x", "ch", "sh")) else f"{holder}s"
        preposition = self.rng.choice(
            ("in", "in", "into") if kind == "in" else ("on", "on", "onto")
        )
        phrase = self.words.say("sets", key).format(
            **{"in": preposition}, holder=holder, holders=many, property=spoken
        )
        what = nouns.sets.class_set() if self.words.chance(0.8) else nouns.sets.everything()
        argument = f"same({literal('colour' if spoken == 'color' else spoken)}, {literal(many)})"
        where = Said("", (argument,), forms={"in": phrase, "to": phrase, "to2": phrase}, kind=kind)
        if key == "same" and self.words.chance(0.2):
            found = self.nouns.sets.kind()
            what = class_said(found)
            text = self.words.choose(SAME_SENTENCES).format(
                many=found.many, one=found.one, holder=holder, holders=many, p=spoken
            )
            return text, put_steps(what, where), text.split()[0] not in {"the", "each", "every"}
        bank = [
            each for each in self.words.lists["put"]["do"] if "{h.in}" in each or "{h.to}" in each
        ]
        template = self.rng.choice(bank[:8]) if self.words.chance(0.5) else self.words.choose(bank)
        return fill(template, {"x": what, "h": where}), put_steps(what, where), True

    def put_each(self) -> tuple[str, list[Step], bool]:
        """``one candy in each cup``."""
        nouns = self.nouns
        kind = self.rng.choice(("in", "in", "on"))
        holder = self.words.choose(self.words.lists["words"]["containers"][kind])
        many = f"{holder}es" if holder.endswith(("x", "ch", "sh")) else f"{holder}s"
        if self.words.chance(0.3):
            mark = self.nouns.names.adjective()
            holder, many = f"{mark} {holder}", f"{mark} {many}"
        preposition = self.rng.choice(
            ("in", "in", "into") if kind == "in" else ("on", "on", "onto")
        )
        shown = {"in": preposition, "holder": holder, "holders": many}
        found = nouns.sets.kind()
        count = 1
        if self.words.chance(0.4):
            template = self.words.say("sets", "spread")
            what = self.rng.choice(
                (f"the {found.many}", f"all the {found.many}", f"all {found.many}", found.many)
            )
            if "of {x}" in template:
                what = f"the {found.many}"
            text = template.format(x=what, **shown)
            order = text.split()[0] not in {"every", "each", "one"}
        else:
            count = self.rng.choice((1, 1, 1, 2, 2, 3))
            first = (
                self.rng.choice(("one", "a", "one", "a single", "exactly one", "1"))
                if count == 1
                else self.rng.choice((SPOKEN[count - 1], str(count)))
            )
            if first == "a" and found.one[0] in "aeiou":
                first = "an"
            noun = found.one if count == 1 else found.many
            text = self.words.say("sets", "one_each").format(n1=first, one1=noun, **shown)
            order = text.split()[0] in {
                "put",
                "place",
                "give",
                "drop",
                "let",
                "fill",
                "make",
                "set",
                "serve",
            }
        counted = f", count={count}" if count > 1 else ""
        where = Said("", (f"each({literal(many)}{counted})",), kind=kind)
        return text, put_steps(class_said(found), where), order

    # Stacks

    def stack(self) -> tuple[str, list[Step], bool]:
        """A tower, named piece by piece or as a set."""
        bank = self.words.lists["stacks"]
        kind = self.rng.choices(list(bank), (18, 14, 14, 5, 4, 4, 6, 10, 8, 3, 3, 8))[0]
        if kind in (
            "largest_first",
            "smallest_first",
            "left_to_right",
            "right_to_left",
            "any_order",
        ):
            found = self.nouns.sets.kind()
            text = self.words.choose(bank[kind]).format(many=found.many, one=found.one)
            taken = "" if kind == "any_order" else f", order={literal(kind.replace('_', ' '))}"
            argument = f"all({literal(found.many)}{taken})"
            order = text.split()[0] in ORDERS
            return text, [Step(STACK, {"x": argument, "y": "previous"}, on=True)], order
        count = {"two": 2, "on_holder": 2, "four_up": 4, "four_down": 4}.get(kind, 3)
        pieces = self._pieces(count)
        slots = dict(zip("abcd", pieces, strict=False))
        steps: list[Step] = []
        if kind == "on_holder":
            slots["h"] = self.nouns.holder()
            steps += put_steps(pieces[0], slots["h"])
        for lower, upper in itertools.pairwise(pieces):
            steps.append(Step(STACK, {"x": upper.arguments[0], "y": lower.arguments[0]}, on=True))
        if kind == "two":
            steps = [
                Step(STACK, {"x": pieces[0].arguments[0], "y": pieces[1].arguments[0]}, on=True)
            ]
            if "tower of two" in (text := fill(self.words.choose(bank[kind]), slots)):
                return text, steps, True
            return text, steps, False
        return fill(self.words.choose(bank[kind]), slots), steps, False

    def _pieces(self, count: int) -> list[Said]:
        """What the tower is built of: often of one kind in different colours, by the colour alone."""
        draw = self.rng.random()
        if draw < 0.3:
            return [self.nouns.names.with_article(self.nouns.names.noun()) for _ in range(count)]
        lists = self.words.lists["words"]
        noun = self.words.choose([*lists["variants"], "block", "block", "cube"])
        marks = (
            self.rng.sample([*lists["colours"][:8], *lists["materials"][:4]], count)
            if draw < 0.85
            else self.rng.sample(["small", "medium", "large", "tiny"], count)
        )
        style = self.rng.random()
        if style < 0.6:
            return [one(f"the {mark} {noun}", f"{mark} {noun}") for mark in marks]
        if style < 0.8:
            first = one(f"the {marks[0]} {noun}", f"{marks[0]} {noun}")
            return (
                [first, *(one(f"the {mark} one", f"{mark} {noun}") for mark in marks[1:])]
                if count == 2
                else [one(f"the {mark} one", f"{mark} one") for mark in marks]
            )
        article = self.rng.choice(("", "", "the "))
        return [one(f"{article}{mark}", f"{mark} one") for mark in marks]


ORDERS = frozenset(("stack", "build", "make", "pile", "put", "place", "set", "arrange", "use"))
"""First words of a sentence that is an order."""
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


def put_steps(what: Said, where: Said) -> list[Step]:
    """One for each thing that is named."""
    return [
        Step(PUT, {"x": each, "y": where.arguments[0]}, on=where.kind == "on")
        for each in what.arguments
    ]


def read_steps(line: str, made: dict[str, Said]) -> list[Step]:
    """``PUT({x}, {h})`` of a construction."""
    concept, inner = re.fullmatch(r"(\w+)\((.*)\)", line).groups()  # type: ignore[union-attr]
    parts: Sequence[str] = re.split(r", (?![^()]*\))", inner)
    what, where = (arguments(part, made) for part in parts)
    target = re.fullmatch(r"\{(\w+)\}", parts[1])
    on = bool(target) and made[target[1]].kind == "on"
    return [Step(concept, {"x": each, "y": where[0]}, on=on) for each in what]
