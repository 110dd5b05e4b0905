import pytest

from app.storage.jobs import VERSION, Jobs
from tests.engines import workflows_table


@pytest.fixture
def jobs(database):
    jobs = Jobs(database)
    jobs.register_queues()
    yield jobs
    jobs.close()


def waiting(database):
    with database.engine.connect() as connection:
        query = (
            "SELECT workflow_uuid, queue_name, status, serialization, application_version "
            f"FROM {workflows_table(database)}"
        )
        return [tuple(row) for row in connection.exec_driver_sql(query)]


def test_a_job_is_there_once_its_transaction_is_committed(database, jobs):
    with database.transaction() as session:
        jobs.enqueue(session, "planning", "pl_1")
        assert waiting(database) == []
    [(name, queue, status, form, version)] = waiting(database)
    assert (name, queue, status, version) == ("pl_1", "planning", "ENQUEUED", VERSION)
    assert form == "portable_json"


def test_a_job_of_a_failed_transaction_never_was(database, jobs):
    def half():
        with database.transaction() as session:
            jobs.enqueue(session, "planning", "pl_1")
            raise RuntimeError

    with pytest.raises(RuntimeError):
        half()
    assert waiting(database) == []


def test_a_job_enqueued_twice_is_one_job(database, jobs):
    for _ in range(2):
        with database.transaction() as session:
            jobs.enqueue(session, "simulation", "ex_1")
    assert len(waiting(database)) == 1
