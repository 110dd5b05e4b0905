"""A Postgres server of the tests' own, where one is installed."""

import os
import pwd
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from typing import Any

from sqlalchemy import URL, NullPool, create_engine
from sqlalchemy.exc import OperationalError

from app.storage.database import Database

SYSTEM = Path("/usr/lib/postgresql")
OWNER = "progprompt"
START_LIMIT = 60.0  # [s]
HASTY = ("fsync=off", "synchronous_commit=off", "full_page_writes=off", "max_connections=200")
"""Nobody keeps these data, so nobody waits for the disk."""


def programs() -> Path | None:
    """The folder of ``initdb`` and ``postgres``, of the newest version; None where there is none."""
    if found := shutil.which("initdb"):
        return Path(found).resolve().parent
    versions = sorted(SYSTEM.glob("*/bin/initdb"), key=lambda path: int(path.parts[-3]))
    return versions[-1].parent if versions else None


class PostgresServer:
    """Databases on a running server, reached through a socket in its folder: no port is taken."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._names = count()
        self._template: str | None = None

    def url(self, name: str) -> str:
        """The URL of a database here."""
        return URL.create(
            "postgresql", OWNER, database=name, query={"host": str(self._folder)}
        ).render_as_string()

    @contextmanager
    def empty(self) -> Iterator[str]:
        """The URL of a database without tables, gone afterwards."""
        with self._made("") as name:
            yield self.url(name)

    @contextmanager
    def migrated(self) -> Iterator[str]:
        """The URL of a database that the migrations built, gone afterwards."""
        if self._template is None:
            self._template = "migrated"
            self.run(f"CREATE DATABASE {self._template}")
            database = Database(self.url(self._template))
            database.migrate()
            database.close()
        # A copy of its files takes a tenth of the time that a copy by the log takes.
        with self._made(f" TEMPLATE {self._template} STRATEGY file_copy") as name:
            yield self.url(name)

    @contextmanager
    def _made(self, how: str) -> Iterator[str]:
        name = f"fresh_{next(self._names)}"
        self.run(f"CREATE DATABASE {name}{how}")
        yield name
        self.run(f"DROP DATABASE {name} WITH (FORCE)")

    def run(self, statement: str) -> None:
        """Run a statement that belongs to no transaction."""
        engine = create_engine(
            self.url("postgres"), isolation_level="AUTOCOMMIT", poolclass=NullPool
        )
        with engine.connect() as connection:
            connection.exec_driver_sql(statement)


@contextmanager
def running(bin_folder: Path) -> Iterator[PostgresServer]:
    """A server with data of its own in a temporary folder."""
    # Not below pytest's folder: that one is closed to the user the server runs as.
    folder = Path(tempfile.mkdtemp(prefix="progprompt-postgres-"))
    identity = _identity(folder)
    data = folder / "data"
    initdb = [bin_folder / "initdb", "-D", data, "-U", OWNER, "-A", "trust", "-E", "UTF8"]
    subprocess.run([*initdb, "--no-sync"], check=True, capture_output=True, cwd=folder, **identity)
    command: list[str | Path] = [bin_folder / "postgres", "-D", data, "-k", folder, "-h", ""]
    with (folder / "log").open("w") as log:
        process = subprocess.Popen(
            [*command, *(part for one in HASTY for part in ("-c", one))],
            cwd=folder,
            stdout=log,
            stderr=log,
            **identity,
        )
    try:
        server = PostgresServer(folder)
        _wait(server, folder / "log")
        yield server
    finally:
        process.send_signal(signal.SIGQUIT)
        process.wait()
        shutil.rmtree(folder)


def _identity(folder: Path) -> dict[str, Any]:
    """Whom to run as; the server refuses to be run by root."""
    if os.geteuid() != 0:
        return {}
    known = {entry.pw_name for entry in pwd.getpwall()}
    user = pwd.getpwnam("postgres" if "postgres" in known else "nobody")
    os.chown(folder, user.pw_uid, user.pw_gid)
    return {"user": user.pw_uid, "group": user.pw_gid, "extra_groups": ()}


def _wait(server: PostgresServer, log: Path) -> None:
    deadline = time.monotonic() + START_LIMIT
    while True:
        try:
            server.run("SELECT 1")
        except OperationalError:
            if time.monotonic() > deadline:
                raise RuntimeError(f"Postgres did not start:\n{log.read_text()}") from None
            time.sleep(0.05)
        else:
            return
