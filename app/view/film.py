"""Film: a rollout's pictures as viser's client takes them, made once for all who watch."""

import threading
from functools import lru_cache
from typing import NamedTuple

import mujoco
import numpy as np

from app.view.live import STILL, limbs_of, pose_in_parent
from app.view.packets import packed, unpacked
from app.view.recording import record
from app.view.source import Footage

PICTURES = 30
"""A second of the rollout at its own speed or faster has so many [1/s]."""
FINE = 4
"""In slow motion it has so many times more."""
KEPT = 4096
"""Pictures kept at hand; a minute and a half of a rollout, with room for jumps."""
BEGINNING = -1.0
"""The moment before the first frame: everything as it was modelled."""


class Poses(NamedTuple):
    """Where everything that can move stands, each in its parent's frame."""

    positions: np.ndarray
    """[m], shape (n, 3)."""
    quaternions: np.ndarray
    """wxyz, shape (n, 4)."""


class Film:
    """What is sent to a browser: the scene once, and then changes from picture to picture.

    A picture costs its arithmetic and its compression once, however many watch; a browser that
    was at another moment than its neighbours gets its own. Safe to use from several threads.
    """

    def __init__(self, footage: Footage) -> None:
        self.footage = footage
        self._model = footage.model
        self._data = mujoco.MjData(footage.model)
        self._limbs = limbs_of(footage.model)
        self._lock = threading.Lock()
        scene = record(footage.model, np.empty((0, 1 + footage.model.nq)))
        messages, arrays = unpacked(scene)
        self.opening = packed([*messages, {"type": "ReplayDoneMessage"}], arrays)
        """The scene as it was modelled."""
        self._poses = lru_cache(KEPT)(self._posed)
        self._changes = lru_cache(KEPT)(self._changed)

    def moment(self, time: float, speed: float) -> float:
        """The moment of the picture to show at ``time`` [s], where one plays at ``speed``.

        Never beyond what is known, so a picture once made stays true while the rollout grows.
        """
        end = self.footage.duration
        if time >= end:
            return end
        rate = PICTURES if speed >= 1 else PICTURES * FINE
        return np.floor(time * rate + 1e-6).item() / rate

    def picture(self, shown: float, moment: float) -> bytes | None:
        """What leads from the picture of ``shown`` to the one of ``moment``; None if nothing."""
        with self._lock:
            return self._changes(shown, moment)

    def _changed(self, shown: float, moment: float) -> bytes | None:
        before, after = self._poses(shown), self._poses(moment)
        moved = np.abs(after.positions - before.positions).max(axis=1, initial=0) > STILL
        turned = np.abs(after.quaternions - before.quaternions).max(axis=1, initial=0) > STILL
        messages: list[dict[str, object]] = []
        for index, limb in enumerate(self._limbs):
            told = {"name": limb.path, "owner": ""}
            if moved[index]:
                place = after.positions[index].tolist()
                messages.append({"type": "SetPositionMessage", "position": place, **told})
            if turned[index]:
                turn = after.quaternions[index].tolist()
                messages.append({"type": "SetOrientationMessage", "wxyz": turn, **told})
        return packed(messages) if messages else None

    def _posed(self, moment: float) -> Poses:
        beginning = moment == BEGINNING
        self._data.qpos[:] = self._model.qpos0 if beginning else self.footage.at(moment)
        mujoco.mj_kinematics(self._model, self._data)
        poses = [pose_in_parent(self._data, limb) for limb in self._limbs]
        positions, quaternions = zip(*poses, strict=True) if poses else ((), ())
        return Poses(
            np.reshape(positions, (-1, 3)).astype(float),
            np.reshape(quaternions, (-1, 4)).astype(float),
        )
