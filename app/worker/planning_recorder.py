"""PlanningRecorder: the events of planning, written down as they happen."""

import time

from app.domain.trace import CompletionGrew, Event, PlanningEvent, ProgramGrounded
from app.storage import events, plans
from app.storage.database import Database

FLUSH_INTERVAL = 0.1  # [s]


class PlanningRecorder:
    """Stores the events of one plan, and tells the planner to stop once somebody has ended it.

    Nothing is stored after that: who followed the plan has seen its end.

    A planner that is run again after a crash tells its story from the beginning. What is stored
    already is not stored twice: the new completion is compared with the old one, and only what
    goes beyond it is added. A model that writes something else the second time starts a new story.
    """

    def __init__(self, database: Database, plan_id: str) -> None:
        self._database = database
        self._plan_id = plan_id
        with database.reading() as session:
            everything = events.all_of(session, plan_id)
        self._sequence = len(everything)
        stored = _this_time(everything)
        self._stored_kinds = {event.kind for event in stored}
        self._stored_text = "".join(e.text for e in stored if isinstance(e, CompletionGrew))
        self._replaying = bool(stored)
        self._retold: list[PlanningEvent] = []
        self._pending: list[PlanningEvent] = []
        self._flushed_at = 0.0

    def report(self, event: PlanningEvent) -> bool:
        """Take an event; True where the plan was cancelled."""
        self._pending += self._fresh(event)
        growing = isinstance(event, CompletionGrew)
        if growing and time.monotonic() - self._flushed_at < FLUSH_INTERVAL:
            return False
        return self.flush()

    def flush(self) -> bool:
        """Write down what is not yet; True where the plan was cancelled."""
        with self._database.transaction() as session:
            stop = not plans.being_planned(session, self._plan_id)
            if not stop:
                events.append(session, self._plan_id, self._sequence, self._pending)
        self._sequence += len(self._pending)
        self._pending = []
        self._flushed_at = time.monotonic()
        return stop

    def _fresh(self, event: PlanningEvent) -> list[PlanningEvent]:
        """What of the event is worth storing and has not been stored by an earlier run."""
        if isinstance(event, CompletionGrew) and not event.text:
            return []  # Only asks whether to stop.
        if not self._replaying:
            return [event]
        self._retold.append(event)
        if not isinstance(event, CompletionGrew):
            return [] if event.kind in self._stored_kinds else [event]
        text = "".join(e.text for e in self._retold if isinstance(e, CompletionGrew))
        if self._stored_text.startswith(text):
            return []
        self._replaying = False
        if text.startswith(self._stored_text):
            return [CompletionGrew(text=text[len(self._stored_text) :])]
        return self._retold


def _this_time(stored: list[Event]) -> list[Event]:
    """The events since the plan was last complete: before that, it was another program."""
    ends = [place for place, event in enumerate(stored) if isinstance(event, ProgramGrounded)]
    return stored[ends[-1] + 1 :] if ends else stored
