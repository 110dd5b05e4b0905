"""The example programs of a prompt: one file each in static/programs, in the order of their names."""

from collections.abc import Sequence
from functools import cache
from pathlib import Path

from app.domain.action import ActionSignature
from app.domain.program import ActionCall, Assertion, Comment, Pass, Program
from app.programs.parser import parse_program

FOLDER = Path(__file__).resolve().parents[2] / "static" / "programs"


@cache
def load_examples(world: str) -> tuple[Program, ...]:
    """The world's example programs; none where it has no folder."""
    files = sorted((FOLDER / world).glob("*.py"))
    return tuple(parse_program(file.read_text(encoding="utf-8")) for file in files)


def choose_examples(
    world: str, actions: Sequence[ActionSignature], count: int
) -> tuple[Program, ...]:
    """The first so many examples that get by with the actions on offer, if any shows one."""
    offered = {action.name for action in actions}
    fitting = [each for each in load_examples(world) if _used(each) <= offered]
    return tuple(fitting)[: max(count, 0)] if any(map(_used, fitting)) else ()


def ablate(program: Program, *, comments: bool, feedback: bool) -> Program:
    """The program without its comments or without its assertions, as the paper's ablations."""
    dropped = (() if comments else (Comment,)) + (() if feedback else (Assertion,))
    body = tuple(statement for statement in program.body if not isinstance(statement, dropped))
    return Program(name=program.name, objects=program.objects, body=body or (Pass(),))


def _used(program: Program) -> set[str]:
    calls: list[ActionCall] = []
    for statement in program.body:
        if isinstance(statement, ActionCall):
            calls.append(statement)
        elif isinstance(statement, Assertion):
            calls += statement.recovery
    return {call.action for call in calls}
