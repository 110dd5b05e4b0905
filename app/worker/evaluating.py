"""Evaluating: one attempt of an evaluation at a time, so that ordinary plans come in between.

The jobs of an evaluation form lanes. Each attempt puts the next of its lane into the queue in the
transaction that stores its own result: whatever dies, no attempt is lost and none is told twice.
"""

import logging
import time
from collections.abc import Callable

from app.domain.errors import Cancelled, ModelUnavailable, Refused
from app.domain.llm import LanguageModel
from app.evaluation.attempt import Unit, attempt, given_up
from app.evaluation.results import Result, result_document
from app.evaluation.wanted import read_wanted
from app.storage import evaluations
from app.storage.base import now
from app.storage.database import Database
from app.storage.evaluations import UNFINISHED
from app.storage.jobs import Jobs
from app.worker.process import Desk

MAX_ATTEMPTS = 3
LOOK = 0.3
"""How often somebody's wish to stop is looked for while the model writes [s]."""
PREFIX = "ev_"
log = logging.getLogger(__name__)


def job_name(evaluation_id: str, index: int) -> str:
    """What the queue calls an attempt."""
    return f"{evaluation_id}:{index}"


class Evaluating:
    """What a worker of the planning queue does with an attempt of an evaluation."""

    def __init__(
        self, database: Database, jobs: Jobs, open_model: Callable[[str, str], LanguageModel]
    ) -> None:
        self._database = database
        self._jobs = jobs
        self._open_model = open_model
        self._units: tuple[str, list[Unit]] = ("", [])

    def __call__(self, job: str, /) -> None:
        """Make the attempt, store what came of it, and hand on to the next of its lane."""
        evaluation_id, _, place = job.partition(":")
        index = int(place)
        attempts = self._take(evaluation_id, index)
        if attempts is None:
            return
        try:
            unit = self._unit(evaluation_id, index)
            self._keep(evaluation_id, index, self._result(unit, attempts, evaluation_id))
        except Cancelled:
            return
        except (ModelUnavailable, Refused) as error:
            self._fail(evaluation_id, str(error))
        except Exception as error:
            log.exception("an attempt failed unexpectedly")
            self._fail(evaluation_id, f"unexpected {type(error).__name__}: {error}")

    def stopping(self, job: str, /) -> None:
        """The worker stops in good order in the middle of this attempt: not its fault."""
        evaluation_id, _, place = job.partition(":")
        with self._database.transaction() as session:
            row = evaluations.take(session, evaluation_id, int(place))
            row.attempts = max(row.attempts - 1, 0)

    def _take(self, evaluation_id: str, index: int) -> int | None:
        """How often it has been taken up, or None where there is nothing to do."""
        with self._database.transaction() as session:
            owner = evaluations.get(session, evaluation_id, lock=True)
            if owner.status not in UNFINISHED:
                return None
            row = evaluations.take(session, evaluation_id, index)
            if row.result is not None:
                return None
            owner.status = "running"
            owner.started_at = owner.started_at or now()
            row.attempts += 1
            return row.attempts

    def _unit(self, evaluation_id: str, index: int) -> Unit:
        if self._units[0] != evaluation_id:
            with self._database.reading() as session:
                document = evaluations.get(session, evaluation_id).request
            self._units = (evaluation_id, read_wanted(document).evaluation().units())
        return self._units[1][index]

    def _result(self, unit: Unit, attempts: int, evaluation_id: str) -> Result:
        if attempts > MAX_ATTEMPTS:
            return given_up(unit, f"its worker died {MAX_ATTEMPTS} times")
        looked = time.monotonic()

        def stop(_event: object) -> bool:
            nonlocal looked
            if time.monotonic() - looked < LOOK:
                return False
            looked = time.monotonic()
            with self._database.reading() as session:
                return evaluations.status_of(session, evaluation_id) not in UNFINISHED

        return attempt(unit, self._open_model, stop)

    def _keep(self, evaluation_id: str, index: int, result: Result) -> None:
        with self._database.transaction() as session:
            owner = evaluations.get(session, evaluation_id, lock=True)
            row = evaluations.take(session, evaluation_id, index)
            if row.result is not None:
                return
            row.result = result_document(result)
            session.flush()
            done = evaluations.count_done(session, evaluation_id)
            if owner.status in UNFINISHED and done == owner.total:
                owner.status, owner.finished_at = "succeeded", now()
            elif owner.status in UNFINISHED and index + owner.lanes < owner.total:
                following = job_name(evaluation_id, index + owner.lanes)
                self._jobs.enqueue(session, "planning", following)

    def _fail(self, evaluation_id: str, reason: str) -> None:
        with self._database.transaction() as session:
            owner = evaluations.get(session, evaluation_id, lock=True)
            if owner.status in UNFINISHED:
                owner.status, owner.error, owner.finished_at = "failed", reason, now()


class SharedDesk:
    """Plans and attempts of evaluations come to one queue; each goes to its own desk."""

    def __init__(self, planning: Desk, evaluating: Desk) -> None:
        self._planning = planning
        self._evaluating = evaluating

    def __call__(self, owner: str, /) -> None:
        """Take care of it; never raises."""
        self._of(owner)(owner)

    def stopping(self, owner: str, /) -> None:
        """The process ends in good order while this one is under way."""
        self._of(owner).stopping(owner)

    def _of(self, owner: str) -> Desk:
        return self._evaluating if owner.startswith(PREFIX) else self._planning
