"""The example programs of a prompt: one file each in static/programs, in the order of their names."""

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from app.domain.action import ActionSignature
from app.domain.condition import relations
from app.domain.planner import PlannerOptions
from app.domain.program import (
    ActionCall,
    Assertion,
    Branch,
    Comment,
    Loop,
    Pass,
    Program,
    Statement,
)
from app.programs.parser import parse_program

FOLDER = Path(__file__).resolve().parents[2] / "static" / "programs"

Ranking = Callable[[str, Sequence[str]], Sequence[int]]
"""Takes a sentence and texts; gives the texts' places, the one most like the sentence first."""


@cache
def load_examples(world: str) -> tuple[Program, ...]:
    """The world's example programs; none where it has no folder."""
    files = sorted((FOLDER / world).glob("*.py"))
    return tuple(parse_program(file.read_text(encoding="utf-8")) for file in files)


def choose_examples(
    world: str,
    actions: Sequence[ActionSignature],
    options: PlannerOptions,
    sentence: str = "",
    ranking: Ranking | None = None,
) -> tuple[Program, ...]:
    """So many examples as are asked for that get by with the actions on offer, if any shows one.

    They are the first ones, or drawn at random from the seed, or those whose tasks are most
    similar to the sentence, the most similar last, where it is nearest to what is asked.

    Raises:
        ValueError: the most similar ones are asked for without a ranking.
    """
    offered = {action.name for action in actions}
    fitting = [each for each in load_examples(world) if used_actions(each) <= offered]
    if not any(map(used_actions, fitting)):
        return ()
    count = min(max(options.examples, 0), len(fitting))
    match options.choice:
        case "fixed":
            return tuple(fitting[:count])
        case "random":
            return tuple(random.Random(options.seed).sample(fitting, count))
        case "similar":
            if ranking is None:
                raise ValueError("the most similar examples are found by a ranking; none is given")
            order = ranking(sentence, [task_of(each) for each in fitting])
            return tuple(fitting[place] for place in reversed(order[:count]))


def ablate(program: Program, *, comments: bool, feedback: bool) -> Program:
    """The program without its comments or without its assertions, as the paper's ablations."""
    dropped = (() if comments else (Comment,)) + (() if feedback else (Assertion,))
    helpers = tuple(
        replace(helper, body=_without(helper.body, dropped)) for helper in program.helpers
    )
    return replace(program, helpers=helpers, body=_without(program.body, dropped))


def task_of(program: Program) -> str:
    """What an example program does, in words: its name's."""
    return program.name.replace("_", " ")


def used_actions(program: Program) -> frozenset[str]:
    """The action primitives it calls."""
    helpers = {helper.name for helper in program.helpers}
    return frozenset(call.action for call in _calls(program)) - helpers


def asserted_relations(programs: Sequence[Program]) -> frozenset[str]:
    """The relations that their assertions speak of."""
    return frozenset(
        relation.name
        for program in programs
        for statement in every_statement(program)
        if isinstance(statement, Assertion)
        for relation in relations(statement.condition)
    )


def named_objects(program: Program) -> tuple[str, ...]:
    """The objects it lists or, where it lists none, those it speaks of, in order."""
    if program.objects is not None:
        return program.objects
    names: dict[str, None] = {}
    for statement in every_statement(program):
        for call in _calls_of(statement):
            names |= {each: None for each in call.arguments if isinstance(each, str)}
        if isinstance(statement, Assertion | Branch):
            spoken = (name for each in relations(statement.condition) for name in each.arguments)
            names |= dict.fromkeys(spoken)
    return tuple(names)


def every_statement(program: Program) -> Iterator[Statement]:
    """All statements of the program and its helpers, those in blocks after their heads."""
    for helper in program.helpers:
        yield from _within(helper.body)
    yield from _within(program.body)


def _within(statements: Sequence[Statement]) -> Iterator[Statement]:
    for statement in statements:
        yield statement
        if isinstance(statement, Branch):
            yield from _within((*statement.body, *statement.otherwise))
        elif isinstance(statement, Loop):
            yield from _within(statement.body)


def _calls(program: Program) -> Iterator[ActionCall]:
    for statement in every_statement(program):
        yield from _calls_of(statement)


def _calls_of(statement: Statement) -> tuple[ActionCall, ...]:
    if isinstance(statement, ActionCall):
        return (statement,)
    return statement.recovery if isinstance(statement, Assertion) else ()


def _without(
    statements: Sequence[Statement], dropped: tuple[type[Statement], ...]
) -> tuple[Statement, ...]:
    kept: list[Statement] = []
    for statement in statements:
        if isinstance(statement, dropped):
            continue
        if isinstance(statement, Loop):
            kept.append(replace(statement, body=_without(statement.body, dropped)))
        elif isinstance(statement, Branch):
            body = _without(statement.body, dropped)
            otherwise = _without(statement.otherwise, dropped) if statement.otherwise else ()
            kept.append(replace(statement, body=body, otherwise=otherwise))
        else:
            kept.append(statement)
    silent = all(isinstance(each, Comment) for each in kept)
    return (*kept, Pass()) if silent else tuple(kept)
