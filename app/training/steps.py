"""What a sentence asks for, concept by concept, before a robot's own verbs stand for it."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from app.programs.printer import INDENT
from app.training.robots import ON, PUT, STACK, Robot, Verb
from app.training.said import Said, arguments

DECLINE = "DECLINE"
"""The concept of what cannot be done."""
Given = dict[str, str]
"""A verb's arguments by their role."""


@dataclass(frozen=True, slots=True)
class Step:
    """A concept done with arguments, before the robot's own verb stands for it."""

    concept: str
    given: Given
    on: bool = False
    """Whether the place is something to put things on."""

    def verb_of(self, robot: Robot) -> Verb:
        """The robot's own verb for it."""
        verbs = robot.verbs
        if self.concept == STACK:
            return verbs.get(STACK) or verbs.get(ON) or verbs[PUT]
        if self.concept == PUT and self.on and ON in verbs:
            return verbs[ON]
        return verbs[self.concept]


Clause = tuple[str, list[Step], bool]
"""Text, steps, and whether it is an order (which may be wrapped in courtesies)."""


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


def write_steps(steps: Sequence[Step], robot: Robot) -> str:
    """The sketch that does them with this robot's verbs."""
    return write_lines(
        "decline('impossible')" if step.concept == DECLINE else step.verb_of(robot).call(step.given)
        for step in steps
    )


def write_lines(lines: Iterable[str]) -> str:
    """Indented lines, then the empty line that ends them."""
    return "".join(f"{INDENT}{line}\n" for line in lines) + "\n"
