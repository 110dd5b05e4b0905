"""One worker process: a queue, the workflow that serves it, and a heartbeat."""

import logging
import os
import threading
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Protocol, Self, cast

from dbos import DBOS, DBOSConfig

from app.domain.errors import ModelError
from app.storage import workers
from app.storage.database import Database
from app.storage.jobs import WORKFLOWS, Queue, worker_config
from app.storage.workers import WorkerRow

HEARTBEAT_INTERVAL = 1.0  # [s]
log = logging.getLogger(__name__)


class Desk(Protocol):
    """What is done with one item of the queue, and with one that is left in the middle."""

    def __call__(self, owner: str, /) -> None:
        """Take care of the plan or execution; never raises."""
        ...

    def stopping(self, owner: str, /) -> None:
        """The process ends in good order while this one is under way."""
        ...


class WorkerProcess:
    """Serves one queue until it is told to stop."""

    def __init__(
        self,
        database: Database,
        queue: Queue,
        worker_id: str,
        *,
        desk: Desk,
        prepare: Sequence[Callable[[], str]],
    ) -> None:
        """A worker that hands every item of ``queue`` to ``desk``.

        ``prepare`` loads what takes time; each part says what it has.
        """
        self._database = database
        self._queue: Queue = queue
        self._id = worker_id
        self._desk = desk
        self._prepare = prepare
        self._stop = threading.Event()
        self._under_way: str | None = None

    def run(self) -> None:
        """Get ready, then serve until ``stop`` is called.

        An item under way is then left as it is: the next process of the same id takes it up.
        """
        with _Heart(self._database, self._queue, self._id) as heart:
            DBOS(config=cast("DBOSConfig", worker_config(self._database, self._id)))
            DBOS.workflow(name=WORKFLOWS[self._queue], max_recovery_attempts=None)(self._workflow())
            DBOS.listen_queues([self._queue])
            self._get_ready(heart)
            DBOS.launch()
            self._stop.wait()
            if self._under_way is not None:
                self._desk.stopping(self._under_way)

    def stop(self) -> None:
        """Have ``run`` return."""
        self._stop.set()

    def _get_ready(self, heart: "_Heart") -> None:
        try:
            heart.ready("; ".join([part() for part in self._prepare]))
        except ModelError as error:
            # It serves all the same: plans may name another model, or fail with this reason.
            log.warning("not ready: %s", error)
            heart.waiting(str(error))

    def _workflow(self) -> Callable[[str], None]:
        def serve(owner: str) -> None:
            self._under_way = owner
            self._desk(owner)
            self._under_way = None

        return serve


class _Heart:
    """Tells the others that this process is alive, and whether it can work yet."""

    def __init__(self, database: Database, queue: Queue, worker_id: str) -> None:
        self._database = database
        self._queue = queue
        self._id = worker_id
        self._ready = False
        self._detail = "getting ready"
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._beat, name="heartbeat", daemon=True)

    def __enter__(self) -> Self:
        self._tell()
        self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._stop.set()
        self._thread.join()
        with self._database.transaction() as session:
            workers.gone(session, self._id)

    def ready(self, detail: str) -> None:
        """From now on it can work."""
        self._ready, self._detail = True, detail
        self._tell()

    def waiting(self, detail: str) -> None:
        """It cannot work yet, and why."""
        self._detail = detail
        self._tell()

    def _beat(self) -> None:
        while not self._stop.wait(HEARTBEAT_INTERVAL):
            try:
                self._tell()
            except Exception:
                log.exception("could not tell that %s is alive", self._id)

    def _tell(self) -> None:
        row = WorkerRow(
            id=self._id,
            queue=self._queue,
            pid=os.getpid(),
            ready=self._ready,
            detail=self._detail,
        )
        with self._database.transaction() as session:
            workers.report(session, row)
