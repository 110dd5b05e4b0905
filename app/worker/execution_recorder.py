"""ExecutionRecorder: what happens in a rollout, written down in small transactions."""

import time

from app.domain.errors import Cancelled
from app.domain.trace import Checkpoint, ExecutionEvent, Happening, Tick
from app.domain.world import World
from app.storage import checkpoints, events, executions, frames
from app.storage.database import Database
from app.storage.executions import ExecutionRow

FLUSH_INTERVAL = 0.15  # [s] of wall time; also how late a cancellation may be noticed


class ExecutionRecorder:
    """Stores events, frames and checkpoints of one execution.

    A run that is taken up again repeats itself exactly from the last checkpoint on, so it writes
    the same events and frames under the same numbers, and the store keeps the first of each.
    """

    def __init__(self, database: Database, row: ExecutionRow, world: World) -> None:
        self._database = database
        self._id = row.id
        self._world = world
        self._next_event = row.next_event
        self._next_frame = row.next_frame
        self._events: list[ExecutionEvent] = []
        self._flushed_at = time.monotonic()

    def record(self, happening: Happening) -> None:
        """Take what the interpreter yields.

        Raises:
            Cancelled: somebody asked for the execution to stop.
        """
        if isinstance(happening, Checkpoint):
            self.flush(happening)
            return
        if not isinstance(happening, Tick):
            self._events.append(happening)
        if time.monotonic() - self._flushed_at >= FLUSH_INTERVAL:
            self.flush()

    def flush(self, checkpoint: Checkpoint | None = None) -> None:
        """Write down everything that has happened so far.

        Raises:
            Cancelled: somebody asked for the execution to stop.
        """
        recorded = self._world.frames()
        with self._database.transaction() as session:
            events.append(session, self._id, self._next_event, self._events)
            frames.append(session, self._id, self._next_frame, recorded)
            self._next_event += len(self._events)
            self._next_frame += len(recorded)
            if checkpoint is not None:
                checkpoints.put(session, self._id, checkpoint.next_step, self._world.save())
                executions.change(
                    session,
                    self._id,
                    when=("executing",),
                    next_step=checkpoint.next_step,
                    next_event=self._next_event,
                    next_frame=self._next_frame,
                    attempts=1,
                )
            stop = executions.cancelled(session, self._id)
        self._events = []
        self._flushed_at = time.monotonic()
        if stop:
            raise Cancelled

    def end(self) -> None:
        """Write down the last of it, and the state in which the world is left."""
        self.flush()
        with self._database.transaction() as session:
            checkpoints.put(session, self._id, checkpoints.END, self._world.save())
