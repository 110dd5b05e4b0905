import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.condition import AnyOf, Count, Not, Relation
from app.domain.trace import (
    ActionFailed,
    ActionPerformed,
    CallSkipped,
    ExecutionFinished,
    ExecutionStarted,
    GoalChecked,
    Trace,
)
from app.scores import scores

FACTS = st.lists(
    st.builds(
        lambda first, second: Relation("in", (first, second)),
        st.sampled_from("abc"),
        st.sampled_from("xyz"),
    ),
    max_size=5,
).map(tuple)
EVENTS = st.one_of(
    st.builds(
        GoalChecked,
        condition=st.just(Relation("in", ("a", "x"))),
        holds=st.booleans(),
        time=st.just(1.0),
    ),
    st.just(ActionPerformed(line=1, attempts=1, time=1.0)),
    st.just(ActionFailed(line=1, stage="grasp", reason="missed", time=1.0)),
    st.just(CallSkipped(line=1, text="", reason="", time=1.0)),
)
TRACES = st.builds(
    lambda before, events, after: Trace(
        events=(
            ExecutionStarted(facts=before),
            *events,
            ExecutionFinished(facts=after, time=2.0),
        )
    ),
    FACTS,
    st.lists(EVENTS, max_size=8),
    FACTS,
)


def test_the_scores_of_the_paper_are_there():
    assert list(scores) == ["exec", "gcr", "precision", "sr"]


@pytest.mark.parametrize("name", scores)
@settings(max_examples=60, deadline=None)
@given(trace=TRACES)
def test_every_score_is_between_nought_and_one_or_none(name, trace):
    score = scores[name](trace)
    assert score is None or 0 <= score <= 1


@pytest.mark.parametrize("name", scores)
def test_every_score_of_a_trace_that_says_nothing_is_none(name):
    assert scores[name](Trace()) is None
    started = ExecutionStarted(facts=(Relation("in", ("a", "x")),))
    assert scores[name](Trace(events=(started,))) is None


@settings(max_examples=100, deadline=None)
@given(TRACES)
def test_sr_is_one_exactly_where_gcr_is(trace):
    assert (scores["sr"](trace) == 1) == (scores["gcr"](trace) == 1)


def checked(*held):
    condition = Relation("in", ("a", "x"))
    return [GoalChecked(condition=condition, holds=holds, time=1.0) for holds in held]


def test_gcr_is_the_share_of_goal_conditions_that_hold():
    trace = Trace(events=tuple(checked(True, True, False, True)))
    assert scores["gcr"](trace) == 0.75
    assert scores["sr"](trace) == 0.0


def test_exec_counts_failed_and_skipped_calls():
    trace = Trace(
        events=(
            ActionPerformed(line=1, attempts=3, time=1.0),
            ActionFailed(line=2, stage="grasp", reason="missed", time=1.0),
            CallSkipped(line=3, text="", reason="", time=1.0),
            ActionPerformed(line=4, attempts=1, time=1.0),
        )
    )
    assert scores["exec"](trace) == 0.5


def precision(before, after, *goal):
    events = [GoalChecked(condition=condition, holds=True, time=1.0) for condition in goal]
    return scores["precision"](
        Trace(
            events=(
                ExecutionStarted(facts=before),
                *events,
                ExecutionFinished(facts=after, time=2.0),
            )
        )
    )


PEAR, CUP, PEN = (
    Relation("in", pair) for pair in (("pear", "bowl"), ("cup", "box"), ("pen", "cup"))
)


def test_precision_is_the_share_of_untouched_facts_that_last():
    goal = Relation("in", ("plum", "bowl"))
    assert precision((PEAR, CUP, PEN), (PEAR, PEN, goal), goal) == pytest.approx(2 / 3)


@pytest.mark.parametrize(
    "goal",
    [
        Relation("in", ("cup", "bowl")),
        Not(Relation("in", ("cup", "box"))),
        AnyOf((Relation("open", ("cup",)), Relation("in", ("plum", "bowl")))),
        Count("bowl", ("cup", "plum"), 1),
    ],
)
def test_facts_about_what_the_goal_moves_do_not_count(goal):
    assert precision((PEAR, CUP, PEN), (PEAR,), goal) == 1.0
    assert precision((PEAR, CUP, PEN), (), goal) == 0.0


def test_where_nothing_could_be_disturbed_precision_is_one():
    assert precision((), (), Relation("in", ("plum", "bowl"))) == 1.0
