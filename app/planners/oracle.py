"""Oracle: programs written by hand, as the upper bound of what any planner can reach.

A task's program is the function of its name in static/programs/<world>, or the ground truth that a
suite in static/suites gives for its sentence.
"""

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from app.domain.errors import Cancelled, TaskDeclined
from app.domain.instruction import Instruction
from app.domain.llm import Completion, LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import ActionCall, Pass, Program
from app.domain.trace import CompletionGrew, PlanningStarted
from app.planners import planners
from app.programs.examples import load_examples
from app.programs.parser import parse_program
from app.programs.printer import print_program

SUITES = Path(__file__).resolve().parents[2] / "static" / "suites"


@planners.register("oracle")
class Oracle:
    """Asks no model."""

    model = "scripted"
    repairs = False

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Look the program up.

        Raises:
            TaskDeclined: none is written for this sentence over these objects.
            Cancelled: ``report`` asked for it.
        """
        del model  # Unused.
        if report(PlanningStarted(planner=task.options.name, model=None)):
            raise Cancelled("planning was cancelled")
        program = _find(task)
        text = print_program(program)
        if report(CompletionGrew(text=text)):
            raise Cancelled("planning was cancelled")
        completion = Completion(
            text=text,
            model="",
            finish="stop",
            prompt_tokens=0,
            completion_tokens=0,
            seconds=0.0,
        )
        return Draft(prompt=task.instruction.text, completion=completion, program=text)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Truth:
    """A program for one sentence over these objects."""

    sentence: str
    """As a function's name, so that case and full stop do not matter."""
    objects: frozenset[str]
    program: Program


def _find(task: Task) -> Program:
    """The program of this sentence whose objects are all here; of several the one that does most."""
    name = task.instruction.function_name
    known = [each for each in _truths(task.scene.world) if each.sentence == name]
    fitting = [each for each in known if each.objects <= set(task.scene.names)]
    if not fitting:
        missing = sorted(set(known[0].objects - set(task.scene.names)) if known else ())
        raise TaskDeclined(
            f"the program written for it needs what is not here: {', '.join(missing)}"
            if known
            else "no program is written by hand for this sentence; use another planner",
            kind="absent" if known else "unsure",
        )
    return max(
        fitting, key=lambda each: (each.program.body != (Pass(),), len(each.objects))
    ).program


@cache
def _truths(world: str) -> tuple[_Truth, ...]:
    examples = (
        _Truth(sentence=program.name, objects=frozenset(program.objects or ()), program=program)
        for program in load_examples(world)
    )
    entries = (entry for path in sorted(SUITES.glob("*.json*")) for entry in _entries(path))
    here = (each for each in entries if each.get("world", "tabletop") == world)
    return (*examples, *(_truth(each) for each in here if "truth" in each))


def _entries(path: Path) -> list[dict[str, Any]]:
    """A suite's tasks: a JSON list, or one a line."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".jsonl":
        return [json.loads(line) for line in text.splitlines() if line.strip()]
    return json.loads(text)


def _truth(entry: dict[str, Any]) -> _Truth:
    name = Instruction(entry["instruction"]).function_name
    lines = "\n".join(f"    {call}" for call in entry["truth"] or ["pass"])
    program = parse_program(f"def {name}():\n{lines}\n")
    words = {
        word for call in program.body if isinstance(call, ActionCall) for word in call.arguments
    }
    # Where nothing is to be done that is so because of what is there, all of it.
    objects = words or _listed(entry)
    return _Truth(
        sentence=name,
        objects=frozenset(word for word in objects if isinstance(word, str)),
        program=program,
    )


def _listed(entry: dict[str, Any]) -> set[str]:
    described = entry.get("scene", {}).get("objects", ())
    return {*(item["name"] for item in described), *entry.get("objects", ())}
