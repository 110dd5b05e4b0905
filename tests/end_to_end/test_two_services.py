"""Two services share a database: each does its own work, and that of the other when it dies."""

import os
import signal
from contextlib import ExitStack, closing

import pytest
from sqlalchemy import text

from app.storage import plans, workers
from app.storage.database import Database
from tests.end_to_end.conftest import Service
from tests.engines import ENGINES, workflows_table
from tests.processes import within_limit

SLOW = {
    "scene": {"objects": [{"name": "banana"}, {"name": "bowl"}]},
    "instruction": "take twice your time",
    "execute": False,
}


@pytest.fixture(params=ENGINES)
def url(request):
    with request.getfixturevalue(request.param).empty() as url:
        yield url


@pytest.fixture
def database(url):
    with closing(Database(url)) as database:
        yield database


@pytest.fixture
def services(url, script, tmp_path):
    with ExitStack() as stack:
        services = [Service(tmp_path / name, url, script).start() for name in ("one", "two")]
        for service in services:
            stack.callback(service.stop)
        within_limit(lambda: len(services[0].get("/readyz").get("workers", ())) == 4)
        yield services


@pytest.fixture
def planning(services, database):
    """Two plans under way, each with the process that is at it."""

    def processes():
        table = workflows_table(database)
        query = f"SELECT workflow_uuid, executor_id FROM {table} WHERE status = 'PENDING'"
        with database.reading() as session:
            holders = dict(session.execute(text(query)).all())
            pids = {worker.id: worker.pid for worker in workers.alive(session)}
        return {plan_id: pids.get(holder) for plan_id, holder in holders.items()}

    for _ in range(2):
        services[0].http.post("/plans", json=SLOW)
    within_limit(lambda: len(processes()) == 2)
    return processes()


def attempts(database, plan_id):
    with database.reading() as session:
        return plans.get(session, plan_id).attempts


def told_once(service, plan_id):
    plan = service.wait(f"/plans/{plan_id}", "planned", "failed")
    story = service.events(f"/plans/{plan_id}/events")[:-1]
    assert [event["sequence"] for event in story] == list(range(len(story)))
    return "".join(event.get("text", "") for event in story) == plan["completion"]


def test_who_comes_back_takes_nothing_from_the_living(services, database, planning):
    (killed, kept) = planning
    assert len(set(planning.values())) == 2
    os.kill(planning[killed], signal.SIGKILL)
    assert told_once(services[0], killed)
    assert told_once(services[1], kept)
    assert [attempts(database, plan_id) for plan_id in planning] == [2, 1]


def test_a_service_that_dies_for_good_leaves_its_work_to_the_other(services, planning):
    first, second = services
    dead = {first.worker("planning-1"), first.worker("simulation-1")}
    first.stop(signal.SIGKILL)
    for process in dead:
        os.kill(process, signal.SIGKILL)
    assert len(set(planning.values()) & dead) == 1
    for plan_id in planning:
        assert told_once(second, plan_id)
    assert len(second.get("/readyz")["workers"]) == 2
