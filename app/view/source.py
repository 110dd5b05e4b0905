"""Where a view gets its pictures from: a port, and the frames of one rollout as they arrive."""

import threading
import time
from typing import Protocol

import mujoco
import numpy as np

from app.domain.errors import NotThere

Frames = np.ndarray
"""Rows of time [s] and generalized coordinates (qpos), shape (n, 1 + nq), times ascending."""

READ_EVERY = 0.1
"""How often a growing rollout is looked at, whoever watches it [s]."""


class RolloutSource(Protocol):
    """One rollout in the store, finished or still growing."""

    def model(self) -> object:
        """The scene as its world has it drawn; called once."""
        ...

    def frames(self, after: int) -> Frames:
        """The frames stored so far but for the first ``after``; shape (n, 1 + nq), n may be 0."""
        ...

    def finished(self) -> bool:
        """Whether no more frames will come."""
        ...


def model_of(source: RolloutSource) -> mujoco.MjModel:
    """The model that its frames are poses of.

    Raises:
        TypeError: its world has something drawn that is no such model.
    """
    model = source.model()
    if not isinstance(model, mujoco.MjModel):
        raise TypeError(f"{type(model).__name__} is drawn nowhere; a MuJoCo model is wanted")
    return model


class Footage:
    """The frames of one rollout as far as they are known; all who watch it share one."""

    def __init__(self, source: RolloutSource) -> None:
        self.model = model_of(source)
        self.finished = False
        self._source = source
        self._rows: Frames = np.empty((0, 1 + self.model.nq))
        self._read_at = -np.inf
        self._lock = threading.Lock()

    @property
    def duration(self) -> float:
        """Time of the last known frame [s]."""
        return float(self._rows[-1, 0]) if len(self._rows) else 0.0

    @property
    def due(self) -> bool:
        """Whether there may be more to read."""
        return not self.finished and time.monotonic() - self._read_at >= READ_EVERY

    def refresh(self) -> None:
        """Read what is new; does nothing if that was done just now, or if all is known."""
        with self._lock:
            if not self.due:
                return
            self._read_at = time.monotonic()
            # Asked first: frames stored between the two questions must not be missed.
            finished = self._source.finished()
            if len(fresh := self._source.frames(len(self._rows))):
                self._rows = np.concatenate((self._rows, fresh))
            self.finished = finished

    def at(self, moment: float) -> np.ndarray:
        """How everything stood at ``moment`` [s]: qpos (nq,), between frames interpolated."""
        rows = self._rows
        if not len(rows):
            return self.model.qpos0.copy()
        after = int(np.searchsorted(rows[:, 0], moment, side="right"))
        if after == 0 or after == len(rows):
            return rows[max(after - 1, 0), 1:].copy()
        return self._between(rows[after - 1], rows[after], moment)

    def _between(self, before: np.ndarray, after: np.ndarray, moment: float) -> np.ndarray:
        velocity = np.empty(self.model.nv)
        positions = before[1:].copy()
        mujoco.mj_differentiatePos(self.model, velocity, after[0] - before[0], positions, after[1:])
        mujoco.mj_integratePos(self.model, positions, velocity, moment - before[0])
        return positions


class NoMotion(NotThere):
    """The execution's world has nothing that could be drawn."""

    def __init__(self, execution_id: str) -> None:
        super().__init__("motion to be seen in execution", execution_id)
