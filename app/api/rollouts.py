"""StoredRollout: an execution of the store as the viewer wants it."""

import numpy as np

from app.storage import executions, frames
from app.storage.database import Database
from app.storage.documents import read_scene
from app.view.source import NoMotion
from app.worlds import worlds


class StoredRollout:
    """One execution's compiled scene and its frames so far."""

    def __init__(self, database: Database, execution_id: str) -> None:
        """Find the execution.

        Raises:
            NotThere: there is none of this id, or its world knows no motion.
        """
        self._database = database
        self._id = execution_id
        with database.reading() as session:
            self._scene = read_scene(executions.get(session, execution_id).scene)
        if not worlds[self._scene.world].moves:
            raise NoMotion(execution_id)

    def model(self) -> object:
        """The scene as its world has it drawn."""
        return worlds[self._scene.world].model(self._scene)

    def frames(self, after: int) -> np.ndarray:
        """The frames but for the first ``after``: time [s] and qpos, shape (n, 1 + nq)."""
        with self._database.reading() as session:
            data, width = frames.read(session, self._id, after)
        return np.frombuffer(data, "<f4").reshape(-1, width or 1).astype(np.float64)

    def finished(self) -> bool:
        """Whether no more frames will come."""
        with self._database.reading() as session:
            return executions.get(session, self._id).status not in executions.UNFINISHED
