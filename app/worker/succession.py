"""Succession: what workers had under way when they died goes back to its queue."""

import logging

from dbos import DBOS

from app.storage import workers
from app.storage.database import Database
from app.storage.lives import Lives

log = logging.getLogger(__name__)


class Succession:
    """What one worker does for those that are no more.

    All workers do this at the same time: a job that another has taken up meanwhile stays there.
    """

    def __init__(self, database: Database, lives: Lives, worker_id: str) -> None:
        self._database = database
        self._lives = lives
        self._id = worker_id

    def strike_off(self) -> bool:
        """Have the dead no longer listed as workers; whether there were any."""
        with self._database.reading() as session:
            dead = [worker_id for worker_id in workers.listed(session) if self._has_died(worker_id)]
        if dead:
            with self._database.transaction() as session:
                workers.gone(session, dead)
        return bool(dead)

    def take_over(self) -> None:
        """Put back every job whose worker is no more, listed or not; DBOS has been launched.

        It reads through all jobs there ever were, so it is for when somebody has died.
        """
        pending = DBOS.list_workflows(status="PENDING", load_input=False, load_output=False)
        holders = {job.executor_id for job in pending if job.executor_id is not None}
        if dead := [holder for holder in holders if self._has_died(holder)]:
            log.info("takes over from %s", ", ".join(dead))
            DBOS._recover_pending_workflows(dead)  # as a recovery service of DBOS would

    def _has_died(self, worker_id: str) -> bool:
        return worker_id != self._id and self._lives.is_over(worker_id)
