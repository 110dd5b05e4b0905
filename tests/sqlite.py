"""SQLite files in a folder of the tests' own."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path

from app.storage.database import Database


class SqliteFiles:
    """Databases in files of one folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._names = count()
        self._template: Path | None = None

    @contextmanager
    def empty(self) -> Iterator[str]:
        """The URL of a database without tables."""
        yield f"sqlite:///{self._fresh()}"

    @contextmanager
    def migrated(self) -> Iterator[str]:
        """The URL of a database that the migrations built."""
        if self._template is None:
            self._template = self._folder / "template.sqlite"
            database = Database(f"sqlite:///{self._template}")
            database.migrate()
            with database.engine.connect() as connection:
                connection.exec_driver_sql("PRAGMA wal_checkpoint(TRUNCATE)")
            database.close()
        path = self._fresh()
        shutil.copy(self._template, path)
        yield f"sqlite:///{path}"

    def _fresh(self) -> Path:
        return self._folder / f"fresh_{next(self._names)}.sqlite"
