"""How often plans are right: strict Plan SR of a planner with a model, by kind of task.

Strictly: the goal is met where nothing slips, no other object was moved, and what cannot be done
moves nothing.
"""

import itertools
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from app.domain.errors import ModelError, ProgramRefused, TaskDeclined
from app.domain.instruction import Instruction
from app.domain.llm import CompletionRequest, LanguageModel
from app.domain.planner import Planner, PlannerOptions, Task
from app.domain.trace import PlanningEvent
from app.evaluation.intervals import wilson
from app.programs.sketches.grammar import sketch_grammar
from app.programs.sketches.parser import parse_sketch
from app.programs.sketches.prompt import STOP
from app.training.example import Example
from app.training.executor import outcome
from app.training.generator import generate
from app.training.suites import Item

HELD_SEED = 7
"""Of the held-out sentences, so that everybody measures on the same ones."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What came of one instruction."""

    name: str
    kind: str
    sentence: str
    text: str
    """The program, the sketch, or why there is none."""
    right: bool
    seconds: float


def ask(planner: Planner, model: LanguageModel, item: Item, options: PlannerOptions) -> Answer:
    """One instruction, planned and carried out where nothing slips."""
    started = time.perf_counter()
    task = Task(
        scene=item.scene,
        actions=item.actions,
        instruction=Instruction(item.sentence),
        options=options,
        facts=item.facts,
    )
    try:
        draft = planner.write_program(task, model, _go_on)
        text, program = draft.program, draft.program
    except TaskDeclined as declined:
        text, program = f"# {declined.reason}", "def task():\n    pass\n"
    except (ModelError, ProgramRefused) as error:
        text, program = f"# failed: {error}", ""
    done = outcome(program, item.scene, item.puts)
    right = item.check(done)
    return Answer(item.name, item.kind, item.sentence, text, right, time.perf_counter() - started)


def held_out(per_kind: int, data: Path | None = None) -> list[Example]:
    """As many of each kind of sentence, from nouns, classes and phrasings kept out of training."""
    found: dict[str, list[Example]] = {}
    for example in itertools.islice(generate(HELD_SEED, "held", data), 60 * per_kind):
        mine = found.setdefault(example.kind, [])
        if len(mine) < per_kind:
            mine.append(example)
    return [example for kind in sorted(found) for example in found[kind]]


def ask_sketch(model: LanguageModel, example: Example) -> Answer:
    """One held-out sentence; right where the sketch is the very same."""
    request = CompletionRequest(
        prompt=example.prompt,
        max_tokens=300,
        stop=(STOP,),
        grammar=sketch_grammar(example.actions) if model.follows_grammar else None,
    )
    completion = model.complete(request)
    try:
        right = parse_sketch(completion.text) == parse_sketch(example.target)
    except ProgramRefused:
        right = False
    sentence = example.sentence
    return Answer(example.kind, example.kind, sentence, completion.text, right, completion.seconds)


def figures(answers: Sequence[Answer]) -> dict[str, object]:
    """Rates with 95 % Wilson intervals, overall and by kind."""
    kinds = sorted({answer.kind for answer in answers})
    by_kind = {kind: _rate(each for each in answers if each.kind == kind) for kind in kinds}
    seconds = sorted(answer.seconds for answer in answers)
    median = round(seconds[len(seconds) // 2], 2) if seconds else None
    return {"all": _rate(answers), "median_seconds": median, "kinds": by_kind}


def _rate(answers: Iterable[Answer]) -> dict[str, object]:
    right = [answer.right for answer in answers]
    low, high = wilson(sum(right), len(right))
    return {"right": sum(right), "of": len(right), "interval": [round(low, 3), round(high, 3)]}


def _go_on(event: PlanningEvent) -> bool:
    del event  # Nobody watches.
    return False
