import pytest

from app.domain.errors import NotThere
from app.storage import plans


def test_an_unknown_plan_is_not_there(database):
    with database.reading() as session, pytest.raises(NotThere, match="pl_none"):
        plans.get(session, "pl_none")


def test_an_id_that_no_database_could_hold_is_not_there(database):
    with database.reading() as session, pytest.raises(NotThere):
        plans.get(session, "pl_\0")


def test_a_plan_read_under_a_lock_is_read_anew(database, make_plan):
    plan_id = make_plan().id
    with database.reading() as session:
        seen = plans.get(session, plan_id)
        session.commit()
        with database.transaction() as other:
            plans.change(other, plan_id, when=("queued",), error="why")
        assert plans.get(session, plan_id, lock=True).error == "why"
        assert seen.error == "why"


def test_a_change_happens_only_in_the_statuses_it_is_meant_for(database, make_plan):
    plan = make_plan(status="cancelled")
    with database.transaction() as session:
        assert not plans.change(session, plan.id, when=("queued",), status="planning")
        assert plans.change(session, plan.id, when=("cancelled",), error="why")
    with database.reading() as session:
        found = plans.get(session, plan.id)
    assert (found.status, found.error) == ("cancelled", "why")


def test_pages_run_from_the_newest_to_the_oldest_without_gap_or_overlap(database, make_plan):
    made = [make_plan().id for _ in range(7)]
    seen, before = [], None
    with database.reading() as session:
        while rows := plans.page(session, before=before, limit=3):
            seen += [row.id for row in rows]
            before = rows[-1].serial
    assert seen == made[::-1]


def test_times_come_back_in_utc(database, make_plan):
    plan = make_plan()
    with database.reading() as session:
        assert plans.get(session, plan.id).created_at == plan.created_at
