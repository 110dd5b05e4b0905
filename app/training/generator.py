"""Situated tasks by the thousand: a seed, a scene, a few things asked of it, and the programs.

Tasks about one scene come together in an ``Example``: they share the start of the prompt, so that
training reads it once. Every program is run by the perfect executor before it is let out.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random

from app.domain.program import literal
from app.programs.printer import INDENT
from app.programs.situated import question, situation
from app.training import (
    choosing_tasks,
    described_tasks,
    direct_tasks,
    place_tasks,
    refused_tasks,
    sorting_tasks,
    verb_tasks,
)
from app.training.executor import outcome
from app.training.phrases import Speaker, misspell
from app.training.scenes import Setting, class_scene, look_alike_scene
from app.training.tasks import MAKERS, PUT, WEIGHTS, Answered
from app.training.things import Split, Vocabulary
from app.training.verbs import Verbs, choose_verbs

FOLDERS = (
    *(choosing_tasks, described_tasks, direct_tasks, place_tasks, refused_tasks, sorting_tasks),
)
"""The modules whose makers are asked; importing them registers those."""
TYPOS = 0.07
"""Share of sentences that are misspelt."""
OFTEN = ("sort class", "sort property", "left and right", "same colour", "class and rest")
"""Kinds that may come twice in one scene: hard ones, for which few scenes are fit."""


@dataclass(frozen=True, slots=True)
class Part:
    """One thing asked of a scene, and the program's body."""

    kind: str
    sentence: str
    target: str
    goal: dict[str, str]

    @property
    def question(self) -> str:
        """What follows the situation in the prompt."""
        return question(self.sentence)


@dataclass(frozen=True, slots=True)
class Example:
    """One scene and what was asked of it."""

    objects: dict[str, dict[str, str]]
    """Told properties by the object's name."""
    parts: tuple[Part, ...]
    verbs: Verbs

    @property
    def names(self) -> tuple[str, ...]:
        """The objects' names, in the scene's order."""
        return tuple(self.objects)

    @property
    def situation(self) -> str:
        """The start of the prompt, the same for every part."""
        return situation(self.verbs.imports, self.objects)


def generate(seed: int, split: Split, parts: int = 4) -> Iterator[Example]:
    """Examples without end; the same seed gives the same ones."""
    vocabulary = Vocabulary(split)
    number = 0
    while True:
        rng = Random(f"{split}/{seed}/{number}")
        number += 1
        example = make_example(rng, vocabulary, parts)
        if example.parts:
            yield example


def make_example(rng: Random, vocabulary: Vocabulary, count: int) -> Example:
    """A scene with up to ``count`` different kinds of tasks about it."""
    scene = (class_scene if rng.random() < 0.58 else look_alike_scene)(rng, vocabulary)
    verbs = choose_verbs(rng, vocabulary.split)
    say = Speaker(rng, vocabulary)
    made: list[Part] = []
    for kind in _kinds(rng, verbs):
        if len(made) == count:
            break
        answered = (
            verb_tasks.make(say, scene, verbs) if kind == "verb" else MAKERS[kind](say, scene)
        )
        if answered is not None and all(
            answered.goal != part.goal or kind != part.kind for part in made
        ):
            made.append(_part(rng, kind, answered, scene, verbs))
    return Example(scene.described(), tuple(made), verbs)


def write_body(answered: Answered, verbs: Verbs) -> str:
    """The program's lines, then the empty line that ends it."""
    lines: list[str] = []
    for step in answered.steps:
        match step:
            case ("#", text):
                lines.append(f"# {text}")
            case ("pass",):
                lines.append("pass")
            case (action, *arguments):
                name = verbs.put if action == PUT else action
                ordered = arguments[::-1] if action == PUT and verbs.swapped else arguments
                lines.append(f"{name}({', '.join(map(literal, ordered))})")
            case _:
                raise ValueError(f"not a step: {step}")
    return "".join(f"{INDENT}{line}\n" for line in lines) + "\n"


def _kinds(rng: Random, verbs: Verbs) -> list[str]:
    """All kinds of tasks, the weightier more likely at the front."""
    twice = [*WEIGHTS, *OFTEN]
    kinds = sorted(twice, key=lambda kind: rng.random() ** (1 / WEIGHTS[kind]), reverse=True)
    return ["verb", *kinds] if verbs.others and rng.random() < 0.7 else kinds


def _part(rng: Random, kind: str, answered: Answered, scene: Setting, verbs: Verbs) -> Part:
    body = write_body(answered, verbs)
    names = frozenset(item.name for item in scene.order)
    done = outcome(body, names, {verbs.put: verbs.swapped})
    if done.faults or done.places != answered.goal:
        raise ValueError(f"{kind}: {answered} does {done}")
    sentence = answered.sentence
    if rng.random() < TYPOS:
        sentence, kind = misspell(rng, sentence), "typo"
    return Part(kind, sentence, body, answered.goal)
