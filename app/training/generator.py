"""Sketches by the thousand: a seed, an import line, a sentence in one of many phrasings, the sketch.

Every sketch is parsed and grounded on its import line before it is let out.
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from random import Random

from app.domain.action import ActionSignature
from app.domain.planner import Turn
from app.domain.program import literal
from app.programs.printer import INDENT
from app.programs.sketch import Decline, SketchCall
from app.programs.sketch_parser import parse_sketch, print_sketch
from app.programs.sketch_prompt import write_sketch_prompt
from app.training.acting import Actor, around
from app.training.chaining import chain, quoted
from app.training.chores import Chores
from app.training.composing import Composer, Step, read_steps
from app.training.foreign import foreign
from app.training.noise import dress, misspell, typed
from app.training.robots import (
    NEAR,
    ON,
    PUT,
    STACK,
    Robot,
    Verb,
    distract,
    ready_made,
    usual,
    with_put,
)
from app.training.said import Said, fill
from app.training.sentences import sentences
from app.training.words import Split, Words

TYPOS = 0.09
"""Share of sentences that are misspelt."""
WEIGHTS = {
    "put": 32,
    "construction": 26,
    "two clauses": 4,
    "stack": 10,
    "verb": 11,
    "verbs": 4,
    "chain": 9,
    "quoted": 2,
    "around": 3,
    "foreign": 12,
    "impossible": 6,
    "dialogue": 4,
    "sentence": 14,
    "chore": 34,
}
"""How often each kind of sentence is made."""
VERBAL = ("verb", "verbs", "chain", "quoted")
"""Kinds that are about a robot's other verbs, not about putting."""


@dataclass(frozen=True, slots=True)
class Example:
    """What a model is shown, and what it is to write."""

    kind: str
    sentence: str
    actions: tuple[ActionSignature, ...]
    history: tuple[Turn, ...]
    target: str
    """Indented lines, then the empty line that ends them."""

    @property
    def prompt(self) -> str:
        """Exactly what the planner asks with."""
        return write_sketch_prompt(self.sentence, self.actions, self.history)


@dataclass(slots=True)
class Draft:
    """A sentence on its way."""

    text: str
    steps: list[Step]
    order: bool = True
    history: tuple[Turn, ...] = ()
    plain: bool = False
    """Not to be dressed nor misspelt."""
    lines: tuple[str, ...] = ()
    """The sketch where it is no matter of the robot's verbs, with ``actions``."""
    actions: tuple[ActionSignature, ...] = ()


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
    composer = Composer(words, familiar=slips)
    kind = rng.choices(list(WEIGHTS), list(WEIGHTS.values()))[0]
    robot = _robot(words, kind)
    draft = MAKERS[kind](composer, robot)
    if (
        any(step.concept == STACK for step in draft.steps)
        and not robot.can(STACK)
        and words.chance(0.3)
    ):
        robot.add(STACK, words.say("verbs", "stack"))
    if draft.lines:
        return _checked(_chore(words, draft))
    sentence = draft.text
    if not draft.plain:
        sentence = typed(words, dress(words, sentence, order=draft.order))
        if slips:
            kind, sentence = "typo", misspell(rng, sentence)
    target = _target(draft.steps, robot)
    return _checked(Example(kind, sentence, robot.signatures(), draft.history, target))


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


def _put(composer: Composer, _robot: Robot) -> Draft:
    return Draft(*composer.put())


def _construction(composer: Composer, _robot: Robot) -> Draft:
    entries = composer.words.lists["goals"]
    entry = composer.rng.choices(entries, [each["weight"] for each in entries])[0]
    text, steps = composer.constructed(entry)
    return Draft(
        text,
        steps,
        order=text.split()[0] in {"put", "move", "sort", "place", "take"},
        plain=entry["name"] == "injection",
    )


def _two_clauses(composer: Composer, _robot: Robot) -> Draft:
    first, steps, _ = composer.put(imperative=True)
    second, more, _ = composer.put(imperative=True)
    return Draft(_join(composer, first, second), [*steps, *more])


JOINTS = (
    "{a} and {b}",
    "{a}, then {b}",
    "{a} and then {b}",
    "{a}. then {b}",
    "{a}. {b}.",
    "first {a}, then {b}",
    "{a}; {b}",
    "{a}, and {b}",
    "{a} and after that {b}",
    "{a}. after that, {b}",
    "{a}. also {b}",
    "{a}, afterwards {b}",
    "{a} before you {b}",
    "after that is done: {b2}",
    "{a} and also {b}",
    "{a}. next, {b}",
    "1. {a} 2. {b}",
    "{a}, {b}",
    "start with this: {a}. then {b}",
    "{a}. finally, {b}",
    "{a}, and when that's done, {b}",
)


def _join(composer: Composer, first: str, second: str) -> str:
    joint = composer.words.choose([each for each in JOINTS if "{a}" in each])
    return joint.format(a=first.rstrip(".?!"), b=second)


def _stack(composer: Composer, _robot: Robot) -> Draft:
    return Draft(*composer.stack())


def _verb(composer: Composer, robot: Robot) -> Draft:
    return Draft(*Actor(composer, robot).clause())


def _verbs(composer: Composer, robot: Robot) -> Draft:
    actor = Actor(composer, robot)
    first, steps, _ = actor.clause()
    if robot.can(PUT) and composer.words.chance(0.5):
        second, more, _ = composer.put(imperative=True)
    else:
        second, more, _ = actor.clause()
    return Draft(_join(composer, first, second), [*steps, *more])


def _chain(composer: Composer, robot: Robot) -> Draft:
    return Draft(*chain(Actor(composer, robot)))


def _quoted(composer: Composer, robot: Robot) -> Draft:
    return Draft(*quoted(Actor(composer, robot)))


def _around(composer: Composer, robot: Robot) -> Draft:
    return Draft(*around(Actor(composer, robot)))


def _foreign(composer: Composer, robot: Robot) -> Draft:
    text, steps = foreign(composer.words)
    for concept in {step.concept for step in steps} - {PUT, STACK}:
        while not robot.can(concept):
            robot.add(
                concept,
                composer.words.choose(composer.words.lists["verbs"]["concepts"][concept]["names"]),
            )
    text = typed(composer.words, text)
    return Draft(text, steps, plain=True)


def _impossible(composer: Composer, robot: Robot) -> Draft:
    words = composer.words
    nothing = [Step("DECLINE", {})]
    if words.chance(0.45):
        bare = Robot(words.rng)
        text, _, order = Actor(composer, bare).clause()
        wanted = set(bare.verbs)
        if (
            wanted & ASKED_BY_PUTTING
            or any(concept in robot.verbs for concept in wanted)
            or _near(robot, wanted)
        ):
            return _impossible(composer, robot)
        return Draft(text, nothing, order=order)
    template = words.say("refusals", "impossible")
    if any(f"plain {stem}" in robot.verbs for stem in template.split()[:1]) or len(robot.verbs) > 2:
        robot.verbs = {PUT: robot.verbs[PUT]}
    text = fill(template, {"x": _bare(composer)})
    return Draft(text, nothing)


ASKED_BY_PUTTING = {"SWEEP", "COVER", "ATTACH"}


def _near(robot: Robot, wanted: set[str]) -> bool:
    """Whether one of the robot's verbs might be taken for what is asked."""
    return any(wanted & group and group & set(robot.verbs) - {PUT} for group in NEAR)


def _bare(composer: Composer) -> Said:
    return composer.nouns.names.with_article(composer.nouns.names.noun())


def _dialogue(composer: Composer, robot: Robot) -> Draft:
    entry = composer.words.choose(composer.words.lists["dialogues"])
    x, h, y, k = _bare(composer), composer.nouns.holder(), _bare(composer), composer.nouns.holder()
    noun = x.forms["bare"].split()[-1]
    x = Said(x.text, x.arguments, x.words, forms={**x.forms, "other": literal(f"other {noun}")})
    if not h.arguments[0].startswith("'"):
        h = composer.nouns.holders.placed(composer.nouns.names.with_article("bowl"), "in")
    slots = {"x": x, "h": h, "y": y, "k": k}
    robot.verbs = {PUT: robot.verbs[PUT]}
    template = composer.rng.choice(composer.words.lists["put"]["do"][:20])
    earlier = fill(template, slots)
    program = f"def task():\n{_target(read_steps(entry['first'], slots), robot)}"
    said, line = composer.words.choose(entry["then"])
    history = (Turn(instruction=typed(composer.words, earlier), program=program),)
    return Draft(fill(said, slots), read_steps(line, slots), order=False, history=history)


def _whole(composer: Composer, _robot: Robot) -> Draft:
    found = composer.words.choose(sentences())
    if composer.words.chance(0.6):
        found = found.about(composer.nouns.names.noun)
    text = found.text
    if composer.words.chance(0.3):
        text = text.lower().rstrip(".!")
    return Draft(text, list(found.steps), plain=True)


def _ask_chore(composer: Composer, _robot: Robot) -> Draft:
    text, lines, actions = Chores(composer.words).ask()
    return Draft(text, [], lines=tuple(lines), actions=actions)


def _chore(words: Words, draft: Draft) -> Example:
    order = draft.text.split()[0] not in ("i", "it", "the", "there")
    sentence = draft.text
    if words.chance(0.5):
        sentence = typed(words, dress(words, sentence, order=order))
    target = "".join(f"{INDENT}{line}\n" for line in draft.lines) + "\n"
    return Example("chore", sentence, draft.actions, (), target)


MAKERS: dict[str, Callable[[Composer, Robot], Draft]] = {
    "put": _put,
    "construction": _construction,
    "two clauses": _two_clauses,
    "stack": _stack,
    "verb": _verb,
    "verbs": _verbs,
    "chain": _chain,
    "quoted": _quoted,
    "around": _around,
    "foreign": _foreign,
    "impossible": _impossible,
    "dialogue": _dialogue,
    "sentence": _whole,
    "chore": _ask_chore,
}


def _target(steps: list[Step], robot: Robot) -> str:
    lines: list[str] = []
    for step in steps:
        if step.concept == "DECLINE":
            lines.append("decline('impossible')")
        else:
            lines.append(verb_of(step, robot).call(step.given))
    return "".join(f"{INDENT}{line}\n" for line in lines) + "\n"


def verb_of(step: Step, robot: Robot) -> Verb:
    """The robot's own verb for it."""
    verbs = robot.verbs
    if step.concept == STACK:
        return verbs.get(STACK) or verbs.get(ON) or verbs[PUT]
    if step.concept == PUT and step.on and ON in verbs:
        return verbs[ON]
    return verbs[step.concept]


def _checked(example: Example) -> Example:
    """Raises where the sketch does not read back as it was written, or calls what is not offered."""
    sketch = parse_sketch(example.target)
    if parse_sketch(print_sketch(sketch)) != sketch:
        raise ValueError(f"{example.target!r} reads back as {print_sketch(sketch)!r}")
    arity = {action.name: len(action.parameters) for action in example.actions}
    for statement in sketch.body:
        match statement:
            case SketchCall(action, arguments):
                if arity.get(action) != len(arguments):
                    raise ValueError(f"{statement} does not fit {example.prompt!r}")
            case Decline():
                pass
    return example
