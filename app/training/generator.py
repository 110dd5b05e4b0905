"""Sketches by the thousand: a seed, an import line, a sentence in one of many phrasings, the sketch.

Every sketch is parsed and grounded on its import line before it is let out.
"""

import itertools
from collections.abc import Iterator
from pathlib import Path
from random import Random

from app.training.draft import Draft
from app.training.example import Example, checked
from app.training.kinds import KINDS, VERBAL
from app.training.noise import dress, misspell, typed
from app.training.nouns import Nouns
from app.training.robots import STACK, Robot, distract, ready_made, usual, with_put
from app.training.steps import write_lines, write_steps
from app.training.words import Split, Words

TYPOS = 0.09
"""Share of sentences that are misspelt."""


def generate(
    seed: int, split: Split, data: Path | None = None, first: int = 0
) -> Iterator[Example]:
    """Examples without end from the ``first`` on; the same seed gives the same ones."""
    for number in itertools.count(first):
        yield make_example(Random(f"{split}/{seed}/{number}"), split, data)


def make_example(rng: Random, split: Split, data: Path | None = None) -> Example:
    """One sentence for one robot."""
    words = Words(rng, split, data)
    slips = words.chance(TYPOS)
    nouns = Nouns(words, familiar=slips)
    kind = rng.choices(list(KINDS), [each.weight for each in KINDS.values()])[0]
    robot = _robot(words, kind)
    draft = KINDS[kind].make(nouns, robot)
    if (
        any(step.concept == STACK for step in draft.steps)
        and not robot.can(STACK)
        and words.chance(0.3)
    ):
        robot.add(STACK, words.say("verbs", "stack"))
    if draft.lines:
        return checked(_chore(words, draft))
    sentence = draft.text
    if not draft.plain:
        sentence = typed(words, dress(words, sentence, order=draft.order))
        if slips:
            kind, sentence = "typo", misspell(rng, sentence)
    target = write_steps(draft.steps, robot)
    return checked(Example(kind, sentence, robot.signatures(), draft.history, target))


def _robot(words: Words, kind: str) -> Robot:
    if kind in VERBAL and words.chance(0.45):
        robot = Robot(words.rng)
        distract(words, robot, words.rng.choice((0, 0, 1, 2, 3)))
        return robot
    if words.chance(0.3 if kind in (*VERBAL, "around", "stack") else 0.08):
        return ready_made(words)
    draw = words.rng.random()
    if draw < (0.72 if kind not in (*VERBAL, "around") else 0.3):
        robot = usual(words)
        if words.chance(0.14):
            distract(words, robot, words.rng.choice((1, 2, 4, 8)))
        return robot
    return with_put(words, words.rng.choice((0, 0, 0, 1, 2, 3)))


def _chore(words: Words, draft: Draft) -> Example:
    order = draft.text.split()[0] not in ("i", "it", "the", "there")
    sentence = draft.text
    if words.chance(0.5):
        sentence = typed(words, dress(words, sentence, order=order))
    return Example("chore", sentence, draft.actions, (), write_lines(draft.lines))
