"""The import line of a made-up robot: what its verbs are called, their parameters and their order."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from random import Random

from app.domain.action import ActionSignature, Parameter
from app.training.words import Words

PUT, ON, STACK = "PUT", "ON", "STACK"
USUAL = "grab_and_putin(x:obj1, y:obj2)"
_VARIANT = re.compile(r"(\w+)\((.*)\)")
SYLLABLES = (
    *("ba", "bli", "bo", "cha", "clu", "da", "dre", "fi", "flo", "ga", "gri", "ho", "ji", "ka"),
    *("klo", "la", "lo", "mi", "mu", "na", "no", "pa", "plo", "qua", "ra", "ro", "sha", "sni"),
    *("spo", "ta", "tri", "vo", "wa", "wu", "ya", "zi", "zo"),
)
CODAS = ("b", "ck", "g", "ft", "lp", "m", "nk", "p", "rp", "sh", "t", "x", "zz", "le", "fy", "")


@dataclass(frozen=True, slots=True)
class Verb:
    """One verb as the import line shows it: ``pour_into(y:cup, x:jug)``."""

    name: str
    parameters: tuple[str, ...]
    order: tuple[str, ...]
    """The roles of the parameters: ``x`` what it is done to, ``y`` the other, ``n`` and ``m`` numbers."""

    @classmethod
    def read(cls, variant: str) -> "Verb":
        """From ``name(role:parameter, …)``."""
        match = _VARIANT.fullmatch(variant)
        if match is None:
            raise ValueError(f"a verb reads name(x:obj, y:target), not {variant!r}")
        pairs = [each.strip().split(":") for each in match[2].split(",") if each.strip()]
        return cls(match[1], tuple(p for _, p in pairs), tuple(r for r, _ in pairs))

    @property
    def signature(self) -> ActionSignature:
        """As a planner is told of it."""
        return ActionSignature(
            name=self.name,
            parameters=tuple(
                Parameter(name=name, role="number" if role in "nm" else "object")
                for name, role in zip(self.parameters, self.order, strict=True)
            ),
            meaning="",
        )

    def call(self, given: dict[str, str]) -> str:
        """The call with the arguments in this verb's order."""
        return f"{self.name}({', '.join(given[role] for role in self.order)})"


@dataclass(slots=True)
class Robot:
    """Some verbs by the concept each stands for."""

    rng: Random
    verbs: dict[str, Verb] = field(default_factory=dict)

    def signatures(self) -> tuple[ActionSignature, ...]:
        """In the order of the import line."""
        return tuple(verb.signature for verb in self.verbs.values())

    def can(self, concept: str) -> bool:
        """Whether there is a verb for it."""
        return concept in self.verbs

    def add(self, concept: str, variant: str) -> bool:
        """One more verb, unless one is called the same."""
        verb = Verb.read(variant)
        if any(other.name == verb.name for other in self.verbs.values()):
            return False
        self.verbs[concept] = verb
        return True

    def shuffle(self) -> None:
        """Another order on the import line."""
        items = list(self.verbs.items())
        self.rng.shuffle(items)
        self.verbs = dict(items)


def usual(words: Words) -> Robot:
    """The paper's robot."""
    robot = Robot(words.rng)
    robot.add(PUT, USUAL)
    return robot


def ready_made(words: Words) -> Robot:
    """A robot of ``robots.json``, whole or with some of its verbs."""
    robots = words.lists["robots"]
    entry = words.rng.choices(robots, [each["weight"] for each in robots])[0]
    robot = Robot(words.rng)
    whole = words.chance(0.1 if entry.get("few") else 0.8)
    kept = {PUT, *words.rng.sample(list(entry["verbs"]), words.rng.choice((1, 2, 3, 4, 6)))}
    for concept, variant in entry["verbs"].items():
        if whole or concept in kept:
            robot.add(concept, variant)
    return robot


def with_put(words: Words, others: int = 0) -> Robot:
    """A robot that can put things somewhere, by whatever name, and perhaps more."""
    robot = Robot(words.rng)
    robot.add(PUT, USUAL if words.chance(0.4) else words.say("verbs", "put"))
    if words.chance(0.25):
        while not robot.add(ON, words.say("verbs", "stack")):
            pass
    distract(words, robot, others)
    if words.chance(0.5):
        robot.shuffle()
    return robot


def distract(words: Words, robot: Robot, count: int, avoid: Sequence[str] = ()) -> None:
    """Verbs that are not asked for."""
    concepts = list(words.lists["verbs"]["concepts"])
    for _ in range(count):
        if words.chance(0.25):
            stem = words.say("verbs", "plain").split("|")[0]
            if stem not in avoid:
                robot.add(f"plain {stem}", f"{stem}(x:{_parameter(words)})")
        else:
            concept = words.rng.choice(concepts)
            if concept not in avoid and not robot.can(concept):
                variant = words.choose(words.lists["verbs"]["concepts"][concept]["names"])
                if not clashes(robot, concept):
                    robot.add(concept, variant)


def equip(words: Words, robot: Robot, concept: str) -> None:
    """A verb for the concept, unless the robot has one."""
    while not robot.can(concept):
        robot.add(concept, words.choose(words.lists["verbs"]["concepts"][concept]["names"]))


NEAR = (
    {"PUSH", "PUSH1", "PUSHTO"},
    {"WIPE", "WIPEWITH", "plain wash", "plain dust"},
    {"PICK", "plain lift", "plain hold"},
    {"WALK", "SIT"},
    {"PUT", "SWEEP", "HAND"},
    {"NEXTTO", "LEFTOF"},
    {"POUR", "plain empty"},
)
"""Groups of which a robot has one, so that it is plain which is asked for."""


def clashes(robot: Robot, concept: str) -> bool:
    """Whether the robot has something much like it."""
    return any(concept in group and any(map(robot.can, group)) for group in NEAR)


def invented(rng: Random) -> str:
    """A verb nobody has heard of."""
    return rng.choice(SYLLABLES) + rng.choice(("", rng.choice(SYLLABLES))) + rng.choice(CODAS)


def _parameter(words: Words) -> str:
    return words.rng.choice(
        ("obj", "obj", "item", "thing", "o", "object", "target", "part", "what", "obj1")
    )
