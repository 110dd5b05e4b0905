"""Lives: which workers are alive, told by locks that the system lets go of at their death.

A heartbeat would not do: who has been silent for long may only have been held up, and goes on.
"""

import fcntl
import hashlib
import secrets
from typing import Protocol

import psycopg
from sqlalchemy import Engine, text

from app.storage.database import Database

SILENCE_LIMIT = 10  # [s] after which a connection that carries no answer counts as lost
PROBE_AFTER, PROBE_EVERY, PROBES = 10, 5, 3
"""When the server asks whether a silent worker's machine is still there, and how often [s]. It takes
longer to let go of a lock than its holder takes to notice that it has lost the connection."""


class Lives(Protocol):
    """The lives of the workers of one database; no id is ever lived under twice."""

    def begin(self, worker_id: str) -> bool:
        """Live under this id until this process ends; False where another one does."""
        ...

    def lasts(self) -> bool:
        """Whether this process still counts as alive: without it others may take its work."""
        ...

    def is_over(self, worker_id: str) -> bool:
        """Whether nobody lives under this id, which must not be this process's own."""
        ...

    def close(self) -> None:
        """Live no longer; whoever ends does so without it."""
        ...


def lives_of(database: Database) -> Lives:
    """The lives of this database's workers; to be made once in a process."""
    if database.engine.dialect.name == "sqlite":
        return _OneMachine(f"{database.engine.url.database}-lives")
    return _Server(database.engine)


def new_life(lives: Lives, name: str) -> str:
    """Live under a fresh id that begins with ``name``; the id."""
    while not lives.begin(worker_id := f"{name}-{secrets.token_hex(3)}"):
        pass
    return worker_id


class _OneMachine:
    """Locks on places of a file beside the database; nothing is ever written there."""

    def __init__(self, path: str) -> None:
        # The only one: to close any descriptor of a file is to let go of the process's locks on it.
        self._file = open(path, "a")  # noqa: SIM115

    def begin(self, worker_id: str) -> bool:
        try:
            fcntl.lockf(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, _key(worker_id))
        except OSError:
            return False
        return True

    def lasts(self) -> bool:
        return True

    def is_over(self, worker_id: str) -> bool:
        over = self.begin(worker_id)
        if over:
            fcntl.lockf(self._file, fcntl.LOCK_UN, 1, _key(worker_id))
        return over

    def close(self) -> None:
        self._file.close()


class _Server:
    """Advisory locks, each held by a connection of its worker that does nothing else."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        _, given = engine.dialect.create_connect_args(engine.url)
        given.setdefault("tcp_user_timeout", 1000 * SILENCE_LIMIT)
        self._connection = psycopg.connect(autocommit=True, **given)
        probes = {"idle": PROBE_AFTER, "interval": PROBE_EVERY, "count": PROBES}
        for name, value in probes.items():
            self._connection.execute(
                "SELECT set_config(%s, %s, false)", [f"tcp_keepalives_{name}", str(value)]
            )

    def begin(self, worker_id: str) -> bool:
        asked = self._connection.execute("SELECT pg_try_advisory_lock(%s)", [_key(worker_id)])
        return asked.fetchone() == (True,)

    def lasts(self) -> bool:
        try:
            self._connection.execute("SELECT 1")
        except psycopg.OperationalError:
            return False
        return True

    def is_over(self, worker_id: str) -> bool:
        query = text("SELECT pg_try_advisory_xact_lock(:key)")
        with self._engine.begin() as connection:
            return bool(connection.scalar(query, {"key": _key(worker_id)}))

    def close(self) -> None:
        self._connection.close()


def _key(worker_id: str) -> int:
    """A number for the id that fits a lock; nobody else's locks are likely to have it."""
    return int.from_bytes(hashlib.sha256(worker_id.encode()).digest()[:7])
