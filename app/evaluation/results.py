"""Results: what came of one task under one method in one run; one JSON line each."""

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Literal, TextIO

from pydantic import TypeAdapter

from app.domain.planner import PlannerOptions
from app.rollout import Scores

Status = Literal["planned", "declined", "failed"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Cell:
    """One method of a table: a planner with its switches and its model."""

    name: str
    options: PlannerOptions = field(default_factory=PlannerOptions)


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """How one execution went."""

    scores: Scores
    """By their names: ``sr``, ``gcr``, ``exec``, ``precision`` and ``core_gcr``."""
    strict: bool
    """The goal is met and nothing else was changed."""
    success: bool
    """The goal is met, its order and what must always hold included."""
    unmet: tuple[str, ...] = ()
    """Conditions that do not hold at the end, or did not in time."""
    changed: tuple[str, ...] = ()
    """Facts about objects that were to be left alone, as they became: ``in(cup, box)``."""
    performed: tuple[str, ...] = ()
    """Actions that succeeded, in order."""
    problems: tuple[str, ...] = ()
    """Steps that did not succeed, with stage and reason, in order."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """What a person makes of a result; kept beside the automatic one."""

    success: bool
    note: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Result:
    """One line of the results file; ``key`` says which."""

    key: str
    task: str
    language: str
    category: str
    split: str
    environment: str
    instruction: str
    steps: int
    """Length of the ground truth."""
    impossible: bool
    cell: str
    planner: str
    model: str
    """The model's own name."""
    run: int
    seed: int
    status: Status
    reason: str = ""
    """Why it was declined, or why no program came of it."""
    program: str = ""
    tries: int = 1
    seconds: float = 0.0
    """Wall time of all completions [s]."""
    prompt_tokens: int = 0
    completion_tokens: int = 0
    plan: Judged
    """In the perfect executor."""
    physics: Judged | None = None
    """In the world itself, where that was asked for."""
    symbolic: bool = False
    """Its world is the perfect executor."""
    mistakes: tuple[str, ...] = ()
    verdict: Verdict | None = None


_ONE: TypeAdapter[Result] = TypeAdapter(Result)


def read_result(document: object) -> Result:
    """The result that a JSON object describes."""
    return _ONE.validate_python(document)


def result_document(result: Result) -> dict[str, Any]:
    """The result as a JSON object."""
    return asdict(result)


def read_results(path: Path) -> list[Result]:
    """All whole lines of a results file; of several with one key the last one counts.

    A line that was being written when the process died is no line.
    """
    if not path.exists():
        return []
    found: dict[str, Result] = {}
    for line in path.read_text(encoding="utf-8", errors="replace").split("\n"):
        try:
            result = _ONE.validate_json(line)
        except ValueError:
            continue
        found[result.key] = result
    return list(found.values())


def open_results(path: Path) -> TextIO:
    """The file, to add results to; after half a line that a death left, a new one begins."""
    file = path.open("a", encoding="utf-8")
    if path.read_bytes()[-1:] not in (b"", b"\n"):
        file.write("\n")
    return file


def write_result(file: TextIO, result: Result) -> None:
    """Append a line and see to it that it is written."""
    file.write(json.dumps(result_document(result), ensure_ascii=False) + "\n")
    file.flush()
