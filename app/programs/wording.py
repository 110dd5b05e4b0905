"""Wording: action calls and example programs in plain English, for planners that write no programs.

The words come from the action's own name, so that a new verb needs none of its own:
``grab_and_putin('spoon', 'mug')`` is *grab the spoon and put it in the mug*.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product, zip_longest

from app.domain.action import ActionSignature
from app.domain.planner import Task
from app.domain.program import ActionCall, Argument, Assertion, Comment, Pass, Program
from app.domain.scene import Scene
from app.programs.examples import Ranking, choose_examples, named_objects, task_of

DONE = "done"
"""The step with which a plan ends."""
PARTICLES = ("on", "off", "up", "down", "open", "back", "away", "out")
"""They stand before a lone object: *switch on the lamp*."""
PREPOSITIONS = ("into", "onto", "next_to", "from", "with", "over", "under", "in", "on", "to", "at")
STEMS = ("put", "place", "plug", "switch", "turn", "walk", "look", "stand", "sit", "pour", "move")
"""Verbs that a preposition or a particle may be written to without a gap: ``putin``, ``switchon``."""
TARGETS = {"stack": "on", "back": "on", "give": "to", "hand": "to", "throw": "at", "wipe": "with"}
"""What stands before the second of two things where the action's name has no preposition: else *in*."""
PLACES = {"walk": "to", "go": "to", "look": "at", "sit": "on", "point": "at"}
"""What stands between such a verb and its only object."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SpokenPlan:
    """An example task in plain English."""

    task: str
    objects: tuple[str, ...]
    """Empty where the program lists none."""
    steps: tuple[str, ...]


def say(call: ActionCall, actions: Iterable[ActionSignature] = ()) -> str:
    """The call as a sentence without capital or full stop; the actions tell words from things."""
    words = _split(call.action)
    roles = next((_roles(action) for action in actions if action.name == call.action), ())
    things = [
        _thing(value, role)
        for value, role in zip_longest(call.arguments, roles)
        if value is not None
    ]
    if not things:
        said = " ".join(words)
    elif len(things) == 1:
        said = _about_one(words, things[0])
    elif "word" in roles[1:2]:
        said = " ".join((_about_one(words, things[0]), *things[1:]))
    else:
        said = " ".join((_about_two(words, things[0], things[1]), *things[2:]))
    named = (f"{name} {value}" for name, value in call.keywords)
    return ", ".join((said, *named))


def speak(program: Program, actions: Sequence[ActionSignature] = ()) -> SpokenPlan | None:
    """The program's steps in plain English; None where it has loops, branches or helpers."""
    plain = ActionCall | Assertion | Comment | Pass
    if program.helpers or not all(isinstance(each, plain) for each in program.body):
        return None
    calls = [each for each in program.body if isinstance(each, ActionCall)]
    return SpokenPlan(
        task=task_of(program),
        objects=named_objects(program),
        steps=tuple(say(call, actions) for call in calls),
    )


def spoken_examples(task: Task, ranking: Ranking | None = None) -> tuple[SpokenPlan, ...]:
    """The task's example programs in plain English, of those chosen that can be said."""
    sentence = task.instruction.text
    chosen = choose_examples(task.scene.world, task.actions, task.options, sentence, ranking)
    spoken = (speak(program, task.actions) for program in chosen)
    return tuple(each for each in spoken if each)


def spoken_prompt(
    examples: Iterable[SpokenPlan], task: str, objects: Sequence[str] | None = None
) -> str:
    """The examples with their steps, then the task down to the number of its first step.

    Where ``objects`` are given, they are listed in it, and in the examples that have any.
    """
    shown = (_spoken_plan(each, bare=objects is None) for each in examples)
    asked = SpokenPlan(task=task, objects=tuple(objects or ()), steps=())
    return "\n".join([*shown, f"{_spoken_head(asked)}1."])


def numbered(number: int, step: str) -> str:
    """A step as it stands in the prompt after its number, and the number of the next."""
    return f" {step}\n{number + 1}."


def read_steps(text: str) -> list[str]:
    """The steps of a numbered list that begins after its first number, up to ``done``."""
    steps: list[str] = []
    for line in text.strip().split("\n"):
        step = _NUMBER.sub("", line).strip().rstrip(".")
        if not step or step.lower() == DONE:
            break
        steps.append(step)
    return steps


def _spoken_plan(plan: SpokenPlan, *, bare: bool) -> str:
    shown = SpokenPlan(task=plan.task, objects=() if bare else plan.objects, steps=())
    steps = enumerate((*plan.steps, DONE), start=1)
    return _spoken_head(shown) + "".join(f"{number}. {step}\n" for number, step in steps)


def _spoken_head(plan: SpokenPlan) -> str:
    things = f"Objects: {', '.join(plan.objects)}\n" if plan.objects else ""
    return f"Task: {plan.task}\n{things}"


def all_calls(
    scene: Scene, actions: Iterable[ActionSignature], names: Sequence[str] | None = None
) -> Iterator[ActionCall]:
    """Every call of the actions on these objects of the scene, or on all; none takes one twice.

    Actions with numbers among their parameters are left out: those cannot be listed.
    """
    chosen = scene.names if names is None else tuple(names)
    containers = {item.name for item in scene.objects if item.container}
    holders = tuple(name for name in chosen if name in containers) if containers else chosen
    for action in actions:
        if any(parameter.role == "number" for parameter in action.parameters):
            continue
        choices = {"container": holders, "object": chosen, "support": chosen}
        each = (choices.get(parameter.role, parameter.words) for parameter in action.parameters)
        for arguments in product(*each):
            if len(set(arguments)) == len(arguments):
                yield ActionCall(action=action.name, arguments=arguments)


def _roles(action: ActionSignature) -> tuple[str, ...]:
    return tuple(parameter.role for parameter in action.parameters)


def _thing(value: Argument, role: str | None) -> str:
    if not isinstance(value, str):
        return f"{value:g}"
    return value if role == "word" else f"the {value}"


def _about_one(words: list[str], thing: str) -> str:
    if words[-1] in PARTICLES or words[-1] in PREPOSITIONS:
        return " ".join((*words, thing))
    place = (PLACES[words[-1]],) if words[-1] in PLACES else ()
    return " ".join((*words, *place, thing))


def _about_two(words: list[str], first: str, second: str) -> str:
    """The first thing after the first verb, and ``it`` after each later one."""
    preposition = TARGETS.get(words[-1], "in")
    if words[-1] in PREPOSITIONS:
        *words, preposition = words
    clauses = " ".join(words).split(" and ")
    said = [f"{clause} {'it' if place else first}" for place, clause in enumerate(clauses)]
    return f"{' and '.join(said)} {preposition.replace('_', ' ')} {second}"


def _split(name: str) -> list[str]:
    """The words of an action's name; what is glued to a verb counts as a word."""
    name = name.replace("next_to", "next-to")
    words = [word.replace("-", "_") for word in name.lower().split("_") if word]
    return [part for word in words for part in _unglue(word)]


def _unglue(word: str) -> tuple[str, ...]:
    if found := _GLUED.fullmatch(word):
        return found.group(1), found.group(2)
    return (word,)


_NUMBER = re.compile(r"\A\s*\d+[.)]\s*")
_GLUED = re.compile(f"({'|'.join(STEMS)})({'|'.join((*PREPOSITIONS, *PARTICLES))})")
