"""Database: the engine, its sessions, and the migrations run under a lock."""

import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psycopg
from alembic import command
from alembic.config import Config
from dbos import DBOS
from psycopg.abc import Buffer
from psycopg.types.string import StrDumperUnknown
from sqlalchemy import Connection, Engine, create_engine, event, make_url, text
from sqlalchemy.orm import Session, sessionmaker

MIGRATIONS = Path(__file__).parents[2] / "migrations"
MIGRATION_LOCK = 7_061_985
"""Key of the Postgres advisory lock; any number that nobody else uses."""


class Database:
    """One database, SQLite or Postgres by its URL, in which our tables and the queues' live."""

    def __init__(self, url: str) -> None:
        self.url = url
        self.engine = _open(url)
        self._sessions = sessionmaker(self.engine, expire_on_commit=False)

    @contextmanager
    def transaction(self) -> Iterator[Session]:
        """A session whose changes are committed together at the end, or not at all.

        On SQLite it is the only writer from the start, so what it reads stays true until it
        commits; on Postgres the rows it means to change are to be read with a lock.
        """
        with self._sessions() as session, session.begin():
            if self.engine.dialect.name == "sqlite":
                session.connection().exec_driver_sql("BEGIN IMMEDIATE")
            yield session

    @contextmanager
    def reading(self) -> Iterator[Session]:
        """A session that changes nothing."""
        with self._sessions() as session:
            yield session

    def migrate(self) -> None:
        """Bring the tables up to date; several processes may do this at the same time."""
        with self.engine.connect() as connection, _rebuilding(connection):
            _lock(connection)
            config = Config()
            config.set_main_option("script_location", str(MIGRATIONS))
            config.attributes["connection"] = connection
            command.upgrade(config, "head")
            _check_references(connection)
            connection.commit()
        DBOS.migrate(self.url)

    def close(self) -> None:
        """Give up all connections."""
        self.engine.dispose()


def _open(url: str) -> Engine:
    if make_url(url).get_backend_name() != "sqlite":
        engine = create_engine(url, pool_pre_ping=True, pool_size=10, max_overflow=20)
        event.listen(engine, "connect", _spare_nul)
        return engine
    path = make_url(url).database
    if path and path != ":memory:":
        Path(path).parent.mkdir(parents=True, exist_ok=True)
    engine = create_engine(url, pool_size=10, max_overflow=40)
    event.listen(engine, "connect", _prepare)
    return engine


def _spare_nul(connection: psycopg.Connection, _record: object) -> None:
    connection.adapters.register_dumper(str, _NulReplaced)


class _NulReplaced(StrDumperUnknown):
    """Postgres takes no NUL in a text, but a stranger may ask for an id with one in it."""

    def dump(self, obj: str) -> Buffer | None:
        """The text; a NUL becomes the character that stands for what cannot be shown."""
        return super().dump(obj.replace("\0", "\ufffd"))


def _prepare(connection: sqlite3.Connection, _record: object) -> None:
    """Readers never wait for the writer (WAL); writers take turns from their first statement."""
    connection.isolation_level = "IMMEDIATE"
    connection.execute("PRAGMA busy_timeout = 30000")
    connection.execute("PRAGMA foreign_keys = ON")
    connection.execute("PRAGMA synchronous = NORMAL")
    _write_ahead(connection)


def _write_ahead(connection: sqlite3.Connection, patience: float = 30.0) -> None:
    """Switch to WAL, which stays with the file.

    The very first switch needs the file for itself and does not heed the busy timeout.
    """
    deadline = time.monotonic() + patience
    while connection.execute("PRAGMA journal_mode").fetchone()[0] != "wal":
        try:
            connection.execute("PRAGMA journal_mode = WAL")
        except sqlite3.OperationalError:
            if time.monotonic() > deadline:
                raise
            time.sleep(0.02)


def _lock(connection: Connection) -> None:
    """Let one process migrate at a time; the others wait and then find nothing left to do."""
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql("BEGIN IMMEDIATE")
    else:
        connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": MIGRATION_LOCK})


@contextmanager
def _rebuilding(connection: Connection) -> Iterator[None]:
    """Let SQLite drop a table that others refer to, which is how Alembic changes its columns.

    The switch does nothing inside a transaction, so it surrounds that of the migrations.
    """
    if connection.dialect.name != "sqlite":
        yield
        return
    connection.exec_driver_sql("PRAGMA foreign_keys = OFF")
    try:
        yield
    finally:
        connection.rollback()
        connection.exec_driver_sql("PRAGMA foreign_keys = ON")


def _check_references(connection: Connection) -> None:
    """Nothing may refer to what is not there, although nobody looked meanwhile."""
    if connection.dialect.name != "sqlite":
        return
    if broken := connection.exec_driver_sql("PRAGMA foreign_key_check").fetchall():
        found = ", ".join(sorted({f"{child} to {parent}" for child, _, parent, _ in broken}))
        raise RuntimeError(f"the migrations would break references from {found}; nothing was done")
