"""What every test folder may use: a clean environment, and databases the migrations built."""

import os
import shutil

import pytest

from app.storage.database import Database
from app.worlds import worlds


@pytest.fixture(autouse=True)
def clean_environment(monkeypatch):
    for name in [name for name in os.environ if name.startswith("PROGPROMPT_")]:
        monkeypatch.delenv(name)


@pytest.fixture(scope="session")
def migrated_file(tmp_path_factory):
    """A SQLite file with all migrations run; to be copied, never used."""
    path = tmp_path_factory.mktemp("migrated") / "template.sqlite"
    database = Database(f"sqlite:///{path}")
    database.migrate()
    with database.engine.connect() as connection:
        connection.exec_driver_sql("PRAGMA wal_checkpoint(TRUNCATE)")
    database.close()
    return path


@pytest.fixture
def database(migrated_file, tmp_path):
    path = tmp_path / "progprompt.sqlite"
    shutil.copy(migrated_file, path)
    database = Database(f"sqlite:///{path}")
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
        self.catalogue = tabletop.catalogue
        self.complete = tabletop.complete
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
