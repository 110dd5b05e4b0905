"""What every test folder may use: a clean environment, and databases the migrations built."""

import os

import pytest

from app.storage.database import Database
from app.worlds import worlds
from tests.engines import ENGINES
from tests.postgres import programs, running
from tests.sqlite import SqliteFiles


@pytest.fixture(autouse=True)
def clean_environment(monkeypatch):
    for name in [name for name in os.environ if name.startswith("PROGPROMPT_")]:
        monkeypatch.delenv(name)


@pytest.fixture(scope="session")
def sqlite(tmp_path_factory):
    return SqliteFiles(tmp_path_factory.mktemp("sqlite"))


@pytest.fixture(scope="session")
def postgres():
    folder = programs()
    if folder is None:
        pytest.skip("no Postgres server is installed (initdb is not there)")
    with running(folder) as server:
        yield server


@pytest.fixture(params=ENGINES)
def engine(request):
    """Whatever makes databases of one kind; a test that uses it runs on every kind."""
    return request.getfixturevalue(request.param)


@pytest.fixture
def database(engine):
    with engine.migrated() as url:
        database = Database(url)
        yield database
        database.close()


class PerfectTabletop:
    """The tabletop in which nothing ever slips: for tests of what surrounds a world."""

    name = "perfect"

    def __init__(self, tabletop):
        self._tabletop = tabletop
        self.actions = tabletop.actions
        self.default_actions = tabletop.default_actions
        self.relations = tabletop.relations
        self.environments = tabletop.environments
        self.catalogue = tabletop.catalogue
        self.complete = tabletop.complete
        self.model = tabletop.model
        self.moves = False
        self.feedback = False
        self.planner = "progprompt"
        self.robots = ()

    def open(self, scene, seed, perception=None):
        return self.open_perfect(scene, seed)

    def open_perfect(self, scene, seed, state=None):
        world = self._tabletop.open_perfect(scene, seed)
        if state is not None:
            world.restore(state)
        return world


@pytest.fixture(scope="session", autouse=True)
def perfect_world():
    """Register it once; scenes name it by ``"world": "perfect"``."""
    if "perfect" not in worlds:
        worlds.add("perfect", PerfectTabletop(worlds["tabletop"]))
