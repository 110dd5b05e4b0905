import pytest

from app.domain.condition import Not, Relation
from app.domain.goal import Goal
from app.domain.plan import GroundedAssertion, GroundedCall, Plan, RejectedCall
from app.domain.program import Comment
from app.domain.trace import (
    ActionFailed,
    ActionPerformed,
    CallSkipped,
    Checkpoint,
    CommentReached,
    ExecutionFinished,
    ExecutionStarted,
    GoalChecked,
    StageReached,
    Tick,
)
from app.execution.interpreter import MAX_STEPS, check_goal, execute


def put(line, thing, place="bowl"):
    return GroundedCall(line=line, action="put", arguments=(thing, place))


PLAN = Plan(
    steps=(
        Comment(text="fruit", line=2),
        put(3, "pear"),
        RejectedCall(line=4, text="open('bowl')", reason="no action 'open'"),
        put(5, "plum"),
        GroundedAssertion(
            line=6, condition=Relation("in", ("plum", "bowl")), recovery=(put(7, "plum"),)
        ),
        Comment(text="done", line=8),
    )
)
GOAL = Goal((Relation("in", ("pear", "bowl")), Not(Relation("in", ("plum", "bowl")))))


def kinds(happenings):
    return [type(each).__name__ for each in happenings]


def test_a_plan_runs_step_by_step_and_goes_on_after_a_failure(slippery):
    world = slippery(plum=2)
    happenings = list(execute(PLAN, world, goal=GOAL))
    assert [kind for kind in kinds(happenings) if kind not in ("StageReached", "Tick")] == [
        "ExecutionStarted",
        "CommentReached",
        *("ActionStarted", "ActionPerformed", "Checkpoint"),
        *("CallSkipped", "Checkpoint"),
        *("ActionStarted", "ActionFailed", "Checkpoint"),
        *("AssertionChecked", "RecoveryTaken", "ActionStarted", "ActionFailed", "Checkpoint"),
        "CommentReached",
        *("GoalChecked", "GoalChecked"),
        "ExecutionFinished",
    ]
    assert world.settled == 1


def test_events_tell_when_and_why(slippery):
    happenings = list(execute(PLAN, slippery(plum=2), goal=GOAL))
    assert CommentReached(line=2, text="fruit", time=0.0) in happenings
    performed = next(each for each in happenings if isinstance(each, ActionPerformed))
    assert (performed.line, performed.attempts) == (3, 1)
    assert performed.time == pytest.approx(0.4)
    failed = next(each for each in happenings if isinstance(each, ActionFailed))
    assert (failed.line, failed.stage, failed.reason) == (5, "carry", "plum slipped")
    skipped = next(each for each in happenings if isinstance(each, CallSkipped))
    assert (skipped.text, skipped.reason) == ("open('bowl')", "no action 'open'")
    assert [each.holds for each in happenings if isinstance(each, GoalChecked)] == [True, True]
    times = [getattr(each, "time", None) for each in happenings]
    times = [time for time in times if time is not None]
    assert times == sorted(times)


def test_a_stage_is_told_once_and_time_going_by_is_a_tick(slippery):
    happenings = list(execute(Plan(steps=(put(2, "pear"),)), slippery()))
    stages = [each for each in happenings if isinstance(each, StageReached | Tick)]
    assert kinds(stages) == ["StageReached", "Tick", "StageReached", "StageReached", "Tick"]
    assert [each.stage for each in stages if isinstance(each, StageReached)] == [
        "reach",
        "grasp",
        "carry",
    ]


def test_facts_are_told_in_order(slippery):
    world = slippery()
    world.inside = {"plum": "box", "apple": "bowl"}
    happenings = list(execute(Plan(steps=(put(2, "kiwi"),)), world))
    facts = [each.facts for each in happenings if isinstance(each, ExecutionStarted)]
    facts += [each.facts for each in happenings if isinstance(each, ExecutionFinished)]
    assert [[str(fact) for fact in told] for told in facts] == [
        ["in(apple, bowl)", "in(plum, box)"],
        ["in(apple, bowl)", "in(kiwi, bowl)", "in(plum, box)"],
    ]


def test_a_run_taken_up_at_any_checkpoint_yields_what_would_have_come(slippery):
    world = slippery(plum=2)
    whole, saved = [], []
    for happening in execute(PLAN, world, goal=GOAL):
        whole.append(happening)
        if isinstance(happening, Checkpoint):
            saved.append((happening.next_step, world.save(), len(whole)))
    assert len(saved) == 4
    for next_step, state, told in saved:
        later = slippery()
        later.restore(state)
        assert list(execute(PLAN, later, start=next_step, goal=GOAL)) == whole[told:]


def test_an_execution_takes_so_many_steps_and_no_more(slippery):
    plan = Plan(
        steps=tuple(
            step for number in range(MAX_STEPS + 3) for step in (Comment(text=""), put(2, "pear"))
        )
    )
    happenings = list(execute(plan, slippery()))
    assert kinds(happenings).count("ActionPerformed") == MAX_STEPS
    assert kinds(happenings).count("CallSkipped") == 3
    rest = list(execute(plan, slippery(), start=2 * MAX_STEPS))
    assert kinds(rest).count("ActionPerformed") == 0


def test_an_empty_plan_settles_and_checks_the_goal(slippery):
    world = slippery()
    happenings = list(execute(Plan(), world, goal=GOAL))
    assert kinds(happenings) == [
        "ExecutionStarted", "Tick", "GoalChecked", "GoalChecked", "ExecutionFinished",
    ]  # fmt: skip
    assert world.settled == 1


def test_the_goal_is_read_from_the_world(slippery):
    world = slippery()
    world.inside = {"plum": "bowl"}
    assert [each.holds for each in check_goal(GOAL, world)] == [False, False]
