from hypothesis import given
from hypothesis import strategies as st
from pydantic import TypeAdapter

from app.domain.condition import AnyOf, Count, Not, Relation
from app.domain.trace import (
    ActionStarted,
    AssertionChecked,
    CommentReached,
    CompletionGrew,
    Event,
    ExecutionStarted,
    GoalChecked,
)
from app.storage import events

names = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=8)
relations = st.builds(Relation, names, st.lists(names, min_size=1, max_size=3).map(tuple))
conditions = st.recursive(
    relations | st.builds(Count, names, st.lists(names, max_size=3).map(tuple), st.integers(0, 9)),
    lambda inner: st.builds(Not, inner) | st.builds(AnyOf, st.lists(inner).map(tuple)),
    max_leaves=5,
)
times = st.floats(0, 100)


@given(
    st.one_of(
        st.builds(GoalChecked, condition=conditions, holds=st.booleans(), time=times),
        st.builds(
            AssertionChecked,
            line=st.integers(1, 99),
            condition=conditions,
            holds=st.booleans(),
            decider=names,
            time=times,
        ),
        st.builds(ExecutionStarted, facts=st.lists(relations).map(tuple)),
        st.builds(
            ActionStarted,
            line=st.integers(1, 99),
            action=names,
            arguments=st.lists(names | st.floats(-9, 9)).map(tuple),
            time=times,
        ),
    )
)
def test_an_event_comes_back_from_its_stored_form_unchanged(event):
    stored = TypeAdapter(Event).dump_python(event, mode="json")
    assert events.EventRow(body=stored).event == event


def comment(text):
    return CommentReached(line=1, text=text, time=0.0)


def test_events_written_again_under_the_same_numbers_are_kept_once(database):
    with database.transaction() as session:
        events.append(session, "ex_1", 0, [comment("a"), comment("b")])
    with database.transaction() as session:
        events.append(session, "ex_1", 1, [comment("b"), comment("c")])
    with database.reading() as session:
        assert events.all_of(session, "ex_1") == [comment("a"), comment("b"), comment("c")]


def test_owners_number_their_events_apart(database):
    with database.transaction() as session:
        events.append(session, "ex_1", 0, [comment("a")])
        events.append(session, "ex_2", 0, [comment("b")])
    with database.reading() as session:
        assert [row.event for row in events.after(session, "ex_2", -1)] == [comment("b")]


def test_what_comes_after_a_number_is_read_in_order_and_in_parts(database):
    with database.transaction() as session:
        events.append(session, "pl_1", 0, [CompletionGrew(text=str(n)) for n in range(10)])
    with database.reading() as session:
        part = events.after(session, "pl_1", 3, limit=4)
    assert [row.sequence for row in part] == [4, 5, 6, 7]


def test_the_newest_number_grows_with_every_event_of_anyone(database):
    with database.reading() as session:
        before = events.newest(session)
    with database.transaction() as session:
        events.append(session, "ex_9", 0, [comment("a")])
    with database.reading() as session:
        assert events.newest(session) > before
