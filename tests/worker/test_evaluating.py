import pytest

from app.domain.errors import ModelUnavailable
from app.domain.planner import PlannerOptions
from app.evaluation.wanted import Wanted
from app.llm.backends.scripted import Answer, ScriptedModel
from app.storage import evaluations
from app.storage.base import new_id, now
from app.storage.evaluations import EvaluationRow
from app.storage.jobs import Jobs
from app.worker.evaluating import Evaluating, SharedDesk
from tests.engines import workflows_table

BANANA = "    grab_and_putin('banana', 'bowl')\n"


@pytest.fixture
def jobs(database):
    jobs = Jobs(database)
    jobs.register_queues()
    yield jobs
    jobs.close()


@pytest.fixture
def evaluation(database):
    """Three attempts in one lane: the first three robot tasks."""
    wanted = Wanted(
        suite="robot-tasks", methods=(PlannerOptions(name="progprompt", model="scripted"),), limit=3
    )
    row = EvaluationRow(
        id=new_id("ev"),
        created_at=now(),
        status="queued",
        suite=wanted.suite,
        request=wanted.document,
        total=3,
        lanes=1,
    )
    with database.transaction() as session:
        session.add(row)
    return row.id


@pytest.fixture
def evaluating(database, jobs):
    return Evaluating(database, jobs, lambda *_: ScriptedModel([Answer(text=BANANA)]))


@pytest.fixture
def read(database, evaluation):
    def read():
        with database.reading() as session:
            return evaluations.get(session, evaluation), evaluations.results(session, evaluation)

    return read


def queued(database):
    query = f"SELECT workflow_uuid FROM {workflows_table(database)}"
    with database.reading() as session:
        found = session.connection().exec_driver_sql(query)
        return {name for (name,) in found}


def test_an_attempt_is_stored_and_the_next_one_queued(database, evaluation, evaluating, read):
    evaluating(f"{evaluation}:0")
    row, results = read()
    assert row.status == "running"
    assert [each.index for each in results] == [0]
    assert results[0].result["plan"]["strict"] is True
    assert queued(database) == {f"{evaluation}:1"}


def test_the_last_attempt_ends_the_evaluation(evaluation, evaluating, read):
    for index in range(3):
        evaluating(f"{evaluation}:{index}")
    row, results = read()
    assert (row.status, len(results)) == ("succeeded", 3)
    assert row.finished_at is not None


class Killed(BaseException):
    """The process dies; nobody may catch this."""


def die(_prompt):
    raise Killed


def test_an_attempt_that_died_is_made_again_and_told_once(
    database, jobs, evaluation, evaluating, read
):
    with pytest.raises(Killed):
        Evaluating(database, jobs, lambda *_: ScriptedModel(die))(f"{evaluation}:0")
    assert read()[1] == []
    evaluating(f"{evaluation}:0")
    evaluating(f"{evaluation}:0")
    assert len(read()[1]) == 1


def test_an_attempt_that_kills_its_worker_three_times_is_given_up_and_the_rest_goes_on(
    database, jobs, evaluation, evaluating, read
):
    for _ in range(3):
        with pytest.raises(Killed):
            Evaluating(database, jobs, lambda *_: ScriptedModel(die))(f"{evaluation}:0")
    evaluating(f"{evaluation}:0")
    row, results = read()
    assert row.status == "running"
    assert "died 3 times" in results[0].result["reason"]


def test_a_worker_that_stops_in_good_order_does_not_count_against_the_attempt(
    database, jobs, evaluation, evaluating
):
    for _ in range(4):
        with pytest.raises(Killed):
            Evaluating(database, jobs, lambda *_: ScriptedModel(die))(f"{evaluation}:0")
        evaluating.stopping(f"{evaluation}:0")
    with database.reading() as session:
        assert evaluations.result(session, evaluation, 0).attempts == 0


def test_a_cancelled_evaluation_is_left_alone(database, evaluation, evaluating, read):
    with database.transaction() as session:
        evaluations.get(session, evaluation).status = "cancelled"
    evaluating(f"{evaluation}:0")
    assert read()[1] == []
    assert queued(database) == set()


def test_cancelling_stops_the_model_in_the_middle(database, jobs, evaluation, read):
    def write(_prompt):
        with database.transaction() as session:
            evaluations.get(session, evaluation).status = "cancelled"
        return Answer(text="    # on and on\n", endless=True, delay=0.005)

    Evaluating(database, jobs, lambda *_: ScriptedModel(write))(f"{evaluation}:0")
    assert read()[1] == []


def test_a_model_that_cannot_be_had_ends_the_evaluation_with_the_reason(
    database, jobs, evaluation, read
):
    def unavailable(*_):
        raise ModelUnavailable("fetch the weights")

    Evaluating(database, jobs, unavailable)(f"{evaluation}:0")
    row, _ = read()
    assert (row.status, row.error) == ("failed", "fetch the weights")


def test_plans_and_attempts_of_one_queue_go_to_their_own_desks():
    class Desk:
        def __init__(self):
            self.seen = []

        def __call__(self, owner):
            self.seen.append(owner)

        stopping = __call__

    planning, evaluating = Desk(), Desk()
    shared = SharedDesk(planning, evaluating)
    shared("pl_1")
    shared("ev_1:0")
    shared.stopping("ev_1:0")
    assert (planning.seen, evaluating.seen) == (["pl_1"], ["ev_1:0", "ev_1:0"])
