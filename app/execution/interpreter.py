"""Plan + world → the events of its execution."""

from collections.abc import Iterable, Iterator
from itertools import accumulate
from typing import assert_never

from app.domain.condition import Relation, decide
from app.domain.goal import Goal
from app.domain.plan import (
    Call,
    GroundedAssertion,
    GroundedBranch,
    GroundedCall,
    Jump,
    Plan,
    RejectedCall,
    Step,
)
from app.domain.program import Comment
from app.domain.trace import (
    CallSkipped,
    Checkpoint,
    CommentReached,
    ExecutionFinished,
    ExecutionStarted,
    GoalChecked,
    Happening,
    Tick,
)
from app.domain.world import World
from app.execution.assertion import StateCheck, WorldCheck, choose
from app.execution.call import perform, skip
from app.execution.recovery import demand

MAX_STEPS = 200
"""Calls and assertions of one plan; further ones are skipped, comments are not counted."""


def execute(
    plan: Plan,
    world: World,
    *,
    start: int = 0,
    goal: Goal | None = None,
    decider: StateCheck | None = None,
) -> Iterator[Happening]:
    """Run the plan's steps from ``start`` on, let the world come to rest, and check the goal.

    A ``Checkpoint`` follows every step but a comment: a world saved there and restored later goes
    on with ``start=checkpoint.next_step`` and yields what would have come anyway. A ``Tick`` tells
    that time has passed. What goes wrong in the world is an event; the plan goes on.
    """
    decider = decider or WorldCheck()
    if start == 0:
        yield ExecutionStarted(facts=_in_order(world.facts()))
    places = tuple(accumulate(map(_counts, plan.steps)))
    index = start
    while index < len(plan.steps):
        step = plan.steps[index]
        allowed = places[index] <= MAX_STEPS
        index += 1
        match step:
            case Jump(skip=passed_over):
                index += passed_over
                continue
            case GroundedBranch():
                decided = choose(step, world, decider)
                yield decided
                index += 0 if decided.holds else step.skip
            case _:
                yield from _run(step, world, decider, allowed=allowed)
        if not isinstance(step, Comment) and allowed:
            yield Checkpoint(next_step=index)
    world.settle()
    yield Tick()
    yield from check_goal(goal or Goal(), world)
    yield ExecutionFinished(facts=_in_order(world.facts()), time=world.time)


def check_goal(goal: Goal, world: World) -> Iterator[GoalChecked]:
    """Each goal condition as the world has it now."""
    for condition in goal.conditions:
        holds = decide(condition, world.holds)
        yield GoalChecked(condition=condition, holds=holds, time=world.time)


def _run(
    step: Comment | Call | GroundedAssertion, world: World, decider: StateCheck, *, allowed: bool
) -> Iterator[Happening]:
    match step:
        case Comment(text=text, line=line):
            yield CommentReached(line=line, text=text, time=world.time)
        case _ if not allowed:
            yield _left_out(step, world)
        case GroundedCall() | RejectedCall():
            yield from perform(step, world)
        case GroundedAssertion():
            yield from demand(step, world, decider)
        case _:
            assert_never(step)


def _counts(step: Step) -> bool:
    """Whether it is one of those of which there may be so many, passed over or not."""
    return not isinstance(step, Comment | Jump | GroundedBranch)


def _left_out(step: Call | GroundedAssertion, world: World) -> CallSkipped:
    reason = f"an execution takes at most {MAX_STEPS} steps"
    if isinstance(step, GroundedAssertion):
        text = f"assert {step.condition}"
        return CallSkipped(line=step.line, text=text, reason=reason, time=world.time)
    return skip(step, reason, world)


def _in_order(facts: Iterable[Relation]) -> tuple[Relation, ...]:
    return tuple(sorted(facts, key=lambda fact: (fact.name, fact.arguments)))
