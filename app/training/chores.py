"""Sentences that ask for activities at home, for an import line of them: ``activities.json``."""

from collections.abc import Mapping
from typing import Any

from app.domain.action import ActionSignature
from app.domain.program import literal
from app.programs.activities import load_activities
from app.training.said import Said, fill, one
from app.training.words import Words

WHOLE_LINE = 0.25
"""How often every activity stands on the import line, as it does when plans are made."""
SEVERAL, TWO, REFUSED, PLACED = 0.1, 0.18, 0.05, 0.06
"""How often a thing is several, two activities are asked for, none fits, a room tells which."""


class Chores:
    """Somebody who wants things done at home."""

    def __init__(self, words: Words) -> None:
        self.words = words
        self.rng = words.rng
        self._bank: dict[str, Any] = words.lists["activities"]

    def ask(self) -> tuple[str, list[str], tuple[ActionSignature, ...]]:
        """A sentence, the lines of its sketch, and the import line."""
        if self.words.chance(REFUSED):
            text = self.words.say("refusals", "impossible")
            if "{" not in text:
                return text, ["decline('impossible')"], self._line(())
        text, lines, name = self._one()
        used = [name]
        if self.words.chance(TWO):
            other, more, second = self._one()
            joined: str = self.rng.choice(self._bank["joins"])
            text = joined.format(a=text.rstrip("?"), b=other.rstrip("?"))
            lines, used = [*lines, *more], [name, second]
        return text, lines, self._line(used)

    def _one(self) -> tuple[str, list[str], str]:
        entries: Mapping[str, Any] = self._bank["activities"]
        name = self.rng.choices(list(entries), [_weight(each) for each in entries.values()])[0]
        entry = entries[name]
        slots = {slot: self._thing(kind) for slot, kind in entry["slots"].items()}
        text = fill(self.words.choose(entry["say"]), slots)
        seconds = slots["y"].arguments[:1] if "y" in slots else ("",)
        firsts = slots["x"].arguments if "x" in slots else ("",)
        lines = [
            entry["sketch"].replace("{x}", first).replace("{y}", seconds[0]) for first in firsts
        ]
        return text, lines, name

    def _thing(self, kind: str) -> Said:
        lists: Mapping[str, list[str]] = self._bank["lists"]
        noun = self.words.choose(lists[kind])
        movable = kind in ("thing", "dish", "snack", "clothes", "food")
        if movable and self.words.chance(SEVERAL):
            return self._several(noun, lists[kind])
        if self.words.chance(PLACED):
            room = self.rng.choice(lists["room"][:7])
            noun = self.rng.choice((f"{noun} in the {room}", f"{room} {noun}"))
        before = self.rng.choices(("the ", "", "my ", "a "), (50, 36, 9, 5))[0]
        return one(f"{before}{noun}", noun, bare=noun)

    def _several(self, noun: str, others: list[str]) -> Said:
        draw = self.rng.random()
        if draw < 0.5:
            other = self.rng.choice([each for each in others if each != noun])
            article = self.rng.choice(("the ", "the ", "", "my "))
            text = f"{article}{noun} and {article}{other}"
            return Said(
                text, (literal(noun), literal(other)), plural=True, forms={"bare": f"{noun}s"}
            )
        mass = self.words.say("speech", "mass")
        if draw < 0.75:
            return Said(f"some {mass}", (f"all({literal(mass)}, count=1)",), forms={"bare": mass})
        whole = self.rng.choice(("all the ", "all ", "the ", "all my "))
        return Said(f"{whole}{mass}", (f"all({literal(mass)})",), forms={"bare": mass})

    def _line(self, used: tuple[str, ...] | list[str]) -> tuple[ActionSignature, ...]:
        every = [each.signature for each in load_activities("household")]
        if self.words.chance(WHOLE_LINE):
            return tuple(every)
        others = [each for each in every if each.name not in used]
        kept = {each.name for each in self.rng.sample(others, self.rng.choice((3, 6, 10, 16)))}
        chosen = [each for each in every if each.name in kept or each.name in used]
        self.rng.shuffle(chosen)
        return tuple(chosen)


def _weight(entry: Mapping[str, Any]) -> float:
    return 3.0 if len(entry["say"]) > 18 else 1.5 if entry["slots"] else 1.0
