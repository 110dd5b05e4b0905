"""A rollout as one file that plays in any browser: viser's own ``.viser`` format."""

import mujoco
import numpy as np

from app.view.live import Drawing
from app.view.quiet import open_server
from app.view.source import RolloutSource, model_of

RATE = 30.0
"""Pictures a second; frames in between are left out [1/s]."""


def record_rollout(source: RolloutSource) -> bytes:
    """The bytes of a ``.viser`` file of all there is of a rollout so far."""
    return record(model_of(source), source.frames(0))


def record(model: mujoco.MjModel, frames: np.ndarray) -> bytes:
    """The bytes of a ``.viser`` file of ``frames``: rows of time [s] and qpos, (n, 1 + nq)."""
    server = open_server()
    try:
        drawing = Drawing(server, model)
        if len(frames):
            drawing.show(frames[0, 1:])
        film = server.get_scene_serializer()
        shown = 0.0
        for frame in _thinned(frames):
            film.insert_sleep(float(frame[0]) - shown)
            drawing.show(frame[1:])
            shown = float(frame[0])
        return film.serialize()
    finally:
        server.stop()


def _thinned(frames: np.ndarray) -> np.ndarray:
    """At most ``RATE`` rows a second, the last one always among them."""
    if not len(frames):
        return frames
    slots = np.floor(frames[:, 0] * RATE + 1e-6)
    first_of_slot = np.unique(slots, return_index=True)[1]
    return frames[np.union1d(first_of_slot, [len(frames) - 1])]
