"""Clauses for verbs that do other things than put: opening, pouring, washing, what nobody has heard of."""

import re

from app.domain.program import literal
from app.training.composing import Composer, Step
from app.training.robots import Robot, clashes, invented
from app.training.said import Said, fill, one

_VERB_PARAMETERS = (
    "obj",
    "item",
    "thing",
    "o",
    "object",
    "target",
    "part",
    "what",
    "obj1",
    "x",
    "it",
)
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


READY = ("PUSH", "OPEN", "CLOSE", "LEFTOF", "PLACEAT", "SWITCHON", "POUR")


class Actor:
    """Asks for a robot's other verbs."""

    def __init__(self, composer: Composer, robot: Robot) -> None:
        self.composer = composer
        self.words = composer.words
        self.nouns = composer.nouns
        self.rng = composer.rng
        self.robot = robot

    def clause(self, concept: str | None = None) -> tuple[str, list[Step], bool]:
        """One request for a verb, which the robot is given if it has not got it."""
        draw = self.rng.random()
        if concept is None and any(map(self.robot.can, READY)) and self.words.chance(0.6):
            return self.known(self._concept())
        if concept is None and draw < 0.22:
            return self.plain()
        if concept is None and draw < 0.36:
            return self.pair()
        if concept is None and draw < 0.50:
            return self.made_up()
        return self.known(concept or self._concept())

    def _concept(self) -> str:
        names = list(self.words.lists["verbs"]["concepts"])
        own = [each for each in self.robot.verbs if each in names]
        if own and self.words.chance(0.5):
            return self.rng.choice(own)
        for _ in range(20):
            name = self.rng.choice(names)
            if self.robot.can(name) or not clashes(self.robot, name):
                return name
        return "OPEN"

    def known(self, concept: str) -> tuple[str, list[Step], bool]:
        """Of a concept with its own ways of asking."""
        entry = self.words.lists["verbs"]["concepts"][concept]
        while not self.robot.can(concept):
            self.robot.add(concept, self.words.choose(entry["names"]))
        full = "full" in entry and self.words.chance(0.35)
        template = self.words.choose(entry["full" if full else "say"])
        slots = {"x": self.object(entry.get("of", "thing"))}
        if "to" in entry:
            slots["y"] = self.object(entry["to"])
        for name in "nm":
            slots[name] = self.number()
        if "{v}" in template:
            template = template.replace("{v}", self.robot.verbs[concept].name.replace("_", " "))
        steps = self._steps(concept, slots)
        return fill(template, slots), steps, not full

    def _steps(self, concept: str, slots: dict[str, Said]) -> list[Step]:
        several = slots["x"].arguments or ("",)
        second = slots["y"].arguments[0] if "y" in slots and slots["y"].arguments else ""
        numbers = {name: slots[name].forms["digit"] for name in "nm" if name in slots}
        return [Step(concept, {"x": each, "y": second, **numbers}) for each in several]

    def plain(self) -> tuple[str, list[Step], bool]:
        """A verb of everyday language with one object."""
        stem, past, present = self.words.say("verbs", "plain").split("|")
        concept = f"plain {stem}"
        if not self.robot.can(concept):
            name = self.rng.choice(
                (stem, stem, f"{stem}_object", f"{stem}_item", f"do_{stem}", stem.capitalize())
            )
            self.robot.add(concept, f"{name}(x:{self.rng.choice(_VERB_PARAMETERS)})")
        if not self.robot.can(concept):
            return self.known("OPEN")
        what = self.nouns.movable() if self.words.chance(0.5) else self.nouns.thing()
        template = self.words.say("verbs", "plain_say")
        if what.plural:
            template = re.sub(
                r"\{x\} (is|needs|hasn't|isn't)\b", lambda m: f"{{x}} {_MANY[m[1]]}", template
            )
            template = template.replace(" it", " them") if template.endswith(" it") else template
        text = template.replace("{v}", stem).replace("{ved}", past).replace("{ving}", present)
        steps = [Step(concept, {"x": each}) for each in what.arguments]
        return fill(text, {"x": what}), steps, text.split()[0] in {stem, "take", "go"}

    def pair(self) -> tuple[str, list[Step], bool]:
        """A verb with a second object: ``dry the cup with the towel``."""
        stem, preposition, role = self.words.say("verbs", "pair").split("|")
        joined = preposition.replace(" ", "_")
        name = self.rng.choice((stem, f"{stem}_{joined}", f"{stem}_{joined}", f"{stem}_object"))
        first, swapped = (
            self.rng.choice(("obj", "item", "thing", "object", "obj1")),
            self.words.chance(0.3),
        )
        pairs = [f"x:{first}", f"y:{role}"]
        concept = f"pair {stem}"
        if not self.robot.add(concept, f"{name}({', '.join(pairs[::-1] if swapped else pairs)})"):
            return self.known("CLOSE")
        what, other = self.nouns.thing(), self.nouns.thing()
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
        return fill(self.rng.choice(templates), slots), self._steps(concept, slots), True

    def made_up(self) -> tuple[str, list[Step], bool]:
        """A verb of no language, with one or two objects."""
        verb, two = invented(self.rng), self.words.chance(0.5)
        name = self.rng.choice((verb, verb, f"{verb}_it", f"do_{verb}", f"{verb}_object"))
        pairs = [f"x:{self.rng.choice(_VERB_PARAMETERS)}"]
        if two:
            pairs.append(f"y:{self.rng.choice(_SECOND)}")
        if two and pairs[0][2:] == pairs[1][2:]:
            pairs[1] += "2"
        if two and self.words.chance(0.15):
            pairs.reverse()
        if not self.robot.add(f"made {verb}", f"{name}({', '.join(pairs)})"):
            return self.known("OPEN")
        slots = (
            {"x": self.nouns.thing(), "y": self.nouns.thing()}
            if two
            else {"x": self.nouns.movable()}
        )
        template = self.rng.choice(INVENTED_TWO if two else INVENTED_ONE)
        preposition = self.rng.choice(PREPOSITIONS)
        if two and pairs[0].startswith("y:"):
            preposition = "with"
        text = template.replace("{v}", verb).replace("{p}", preposition)
        return fill(text, slots), self._steps(f"made {verb}", slots), text.startswith(verb)

    def object(self, kind: str) -> Said:
        """What a verb is done to."""
        nouns, lists = self.nouns, self.words.lists["speech"]
        if kind in ("thing", "holder"):
            return nouns.thing() if kind == "thing" else nouns.holder()
        if kind == "direction":
            word = self.words.say("speech", "directions")
            adverb = (
                f"to the {word}" if word in ("left", "right", "side", "front", "back") else word
            )
            return Said(word, (literal(word),), literal(word), forms={"adv": adverb})
        if kind == "person":
            person = self.words.say("speech", "persons")
            words = person.removeprefix("the ").removeprefix("my ")
            shown = (
                person.capitalize()
                if person in ("anna", "tom", "maria") and self.words.chance(0.5)
                else person
            )
            return one(shown, words)
        if kind == "text":
            text = self.words.say("speech", "persons_text")
            return one(text, text)
        names = {
            "openable": "openables",
            "device": "devices",
            "vessel": "vessels",
            "place": "places",
        }
        if self.words.chance(0.15):
            return nouns.thing()
        noun = self.words.choose(lists[names[kind]])
        if self.words.chance(0.12):
            noun = f"{nouns.names.adjective()} {noun}"
        return nouns.names.with_article(noun)

    def number(self) -> Said:
        """As it is said and as it is written in a call."""
        shown = self.rng.choice(
            (
                *(
                    str(self.rng.randint(1, 9)),
                    str(self.rng.choice((10, 15, 20, 30, 45, 90, 180, 60))),
                ),
                *(
                    f"0.{self.rng.randint(1, 9)}",
                    f"0.{self.rng.randint(10, 99)}",
                    f"-0.{self.rng.randint(1, 9)}",
                ),
            )
        )
        return Said(shown, (), forms={"digit": shown})


_MANY = {"is": "are", "needs": "need", "hasn't": "haven't", "isn't": "aren't"}
AROUND = {
    "open put": (
        "open {h} and put {x} {h.there}",
        "open {h}, then put {x} {h.there}",
        "put {x} {h.in}, but open {h} first",
        "open up {h} and place {x} {h.there}",
        "open {h}. put {x} {h.there}.",
        "{h} is closed. open it and put {x} {h.there}",
        "before putting {x} {h.in}, open {h}",
        "after opening {h}, put {x} {h.in}",
        "open {h} so that you can put {x} {h.there}",
        "first open {h}, then put {x} {h.in}",
    ),
    "put close": (
        "put {x} {h.in} and close {h}",
        "put {x} {h.in}, then close it",
        "put {x} {h.in} and shut it",
        "place {x} {h.in} and close it afterwards",
        "put {x} {h.in}. close {h}.",
        "after putting {x} {h.in}, close it",
        "close {h} after you have put {x} {h.there}",
        "once {x} {x?is|are} {h.in}, shut {h}",
        "store {x} {h.in} and then close {h}",
        "put {x} {h.in} and don't leave it open",
    ),
    "open put close": (
        "open {h}, put {x} {h.there} and close it",
        "open {h}, put {x} {h.there}, and close it again",
        "put {x} {h.in}; open it first and close it afterwards",
        "open {h}. put {x} {h.there}. shut {h}.",
        "open {h}, place {x} {h.in}, then shut it again",
    ),
}


def around(actor: Actor) -> tuple[str, list[Step], bool]:
    """Opening and closing about a put."""
    words, composer = actor.words, actor.composer
    kind = words.rng.choice(list(AROUND))
    what = composer.nouns.movable()
    noun = words.choose(words.lists["speech"]["openables"][:20])
    where = composer.nouns.holders.placed(composer.nouns.holders.named(noun), "in")
    if "all(" in where.arguments[0]:
        where = composer.nouns.holders.placed(one(f"the {noun}", noun), "in")
    steps: list[Step] = []
    for part in kind.split():
        concept = part.upper()
        if concept == "PUT":
            steps += [Step("PUT", {"x": each, "y": where.arguments[0]}) for each in what.arguments]
            continue
        entry = words.lists["verbs"]["concepts"][concept]
        while not actor.robot.can(concept):
            actor.robot.add(concept, words.choose(entry["names"]))
        steps.append(Step(concept, {"x": where.arguments[0]}))
    return fill(words.choose(AROUND[kind]), {"x": what, "h": where}), steps, True
