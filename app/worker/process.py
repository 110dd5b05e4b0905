"""One worker process: a queue, the workflow that serves it, and a heartbeat."""

import logging
import os
import threading
from collections.abc import Callable, Sequence
from typing import Protocol, cast

from dbos import DBOS, DBOSConfig

from app.domain.errors import ModelError
from app.storage import workers
from app.storage.database import Database
from app.storage.jobs import WORKFLOWS, Queue, worker_config
from app.storage.lives import Lives, lives_of, new_life
from app.storage.workers import WorkerRow
from app.worker.succession import Succession

HEARTBEAT_INTERVAL = 1.0  # [s]
SUCCESSION_INTERVAL = 1.0  # [s] between looks whether another worker has died
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
        name: str,
        *,
        desk: Desk,
        prepare: Sequence[Callable[[], str]],
    ) -> None:
        """A worker that hands every item of ``queue`` to ``desk``.

        ``name`` is what people know it by; its id is its alone. ``prepare`` loads what takes time;
        each part says what it has.
        """
        self._database = database
        self._queue: Queue = queue
        self._name = name
        self._desk = desk
        self._prepare = prepare
        self._stop = threading.Event()
        self._under_way: str | None = None

    def run(self) -> None:
        """Get ready, then serve until ``stop`` is called.

        An item under way is then left as it is: another worker takes it up, as after a death.
        """
        lives = lives_of(self._database)
        worker_id = new_life(lives, self._name)
        succession = Succession(self._database, lives, worker_id)
        heart = _Heart(self._database, self._queue, worker_id, lives)
        heart.begin()
        DBOS(config=cast("DBOSConfig", worker_config(self._database, worker_id)))
        DBOS.workflow(name=WORKFLOWS[self._queue], max_recovery_attempts=None)(self._workflow())
        DBOS.listen_queues([self._queue])
        succession.strike_off()
        self._get_ready(heart)
        DBOS.launch()
        succession.take_over()
        self._serve(succession)
        heart.stop()
        self._leave(worker_id)

    def stop(self) -> None:
        """Have ``run`` return."""
        self._stop.set()

    def _serve(self, succession: Succession) -> None:
        """The queue is served in threads of its own; here it is seen to that no job is left."""
        while not self._stop.wait(SUCCESSION_INTERVAL):
            try:
                if succession.strike_off():
                    succession.take_over()
            except Exception:
                log.exception("could not look after the work of others")

    def _leave(self, worker_id: str) -> None:
        if self._under_way is not None:
            # It stays listed, so that others see that it is dead and take over.
            self._desk.stopping(self._under_way)
            return
        with self._database.transaction() as session:
            workers.gone(session, [worker_id])

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

    def __init__(self, database: Database, queue: Queue, worker_id: str, lives: Lives) -> None:
        self._database = database
        self._queue = queue
        self._id = worker_id
        self._lives = lives
        self._ready = False
        self._detail = "getting ready"
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._beat, name="heartbeat", daemon=True)

    def begin(self) -> None:
        """Tell it from now on."""
        self._tell()
        self._thread.start()

    def stop(self) -> None:
        """Tell it no longer."""
        self._stop.set()
        self._thread.join()

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
            if not self._lives.lasts():
                log.critical("lost what shows that it is alive; others may take its work")
                os._exit(1)
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
