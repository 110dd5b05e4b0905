import subprocess
import sys
from contextlib import closing

import pytest

from app.storage.database import Database
from app.storage.lives import lives_of, new_life
from tests.processes import within_limit

LIVE = """
import sys
from app.storage.database import Database
from app.storage.lives import lives_of
lives = lives_of(Database(sys.argv[1]))
print(lives.begin("other"), flush=True)
sys.stdin.read()
"""


@pytest.fixture
def lives(database):
    lives = lives_of(database)
    yield lives
    lives.close()


@pytest.fixture
def live(database):
    """Has a process live as ``other``, if that is to be had."""
    started = []

    def live():
        process = subprocess.Popen(
            [sys.executable, "-c", LIVE, database.url],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        started.append(process)
        assert process.stdout is not None
        return process, process.stdout.readline() == "True\n"

    yield live
    for process in started:
        process.kill()
        process.communicate()


def test_a_life_is_one_process_alone_and_over_when_that_is_killed(lives, live):
    process, begun = live()
    assert begun
    assert not lives.is_over("other")
    assert not lives.begin("other")
    assert not live()[1]
    process.kill()
    within_limit(lambda: lives.is_over("other"))
    assert live()[1]


def test_to_ask_whether_a_life_is_over_does_not_begin_it(lives, live):
    assert lives.is_over("other")
    assert live()[1]


def test_every_life_has_an_id_of_its_own(lives):
    ids = {new_life(lives, "planning-1") for _ in range(20)}
    assert len(ids) == 20
    assert all(worker_id.startswith("planning-1-") for worker_id in ids)


def test_who_has_lost_the_server_knows_that_it_no_longer_counts_as_alive(postgres):
    drop = "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname ~ '^fresh'"
    with (
        postgres.migrated() as url,
        closing(Database(url)) as database,
        closing(lives_of(database)) as lives,
    ):
        assert lives.lasts()
        postgres.run(drop)
        assert not lives.lasts()
