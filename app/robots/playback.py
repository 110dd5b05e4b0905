"""Playback: an execution's frames as a trajectory for a real arm."""

import numpy as np

from app.domain.errors import Fault, Refused
from app.domain.robot import JointTrajectory

ARM = slice(1, 8)
FINGERS = slice(8, 10)
"""In a frame of the tabletop: after the time [s] the arm's angles [rad], then how far each finger
is from the middle [m]."""


def trajectory_of(packed: bytes, width: int, *, grip_force: float = 30.0) -> JointTrajectory:
    """What the arm did in these frames, as a service gives them.

    Args:
        packed: little-endian float32, shape (n, width).
        width: numbers of a frame.
        grip_force: with which the fingers are to close [N].

    Raises:
        Refused: they are no frames of the tabletop, or too few.
    """
    if width < FINGERS.stop:
        message = "are none of a robot arm; only what was carried out on the tabletop can be sent"
        raise Refused(Fault(field="frames", message=message))
    frames = np.frombuffer(packed, "<f4").reshape(-1, width).astype(float)
    later = np.diff(frames[:, 0], prepend=-np.inf) > 0  # a frame is told twice where steps meet
    frames = frames[later]
    return JointTrajectory(
        times=tuple((frames[:, 0] - frames[:1, 0]).tolist()),
        positions=tuple(tuple(row) for row in frames[:, ARM].tolist()),
        openings=tuple(np.maximum(frames[:, FINGERS].sum(axis=1), 0.0).tolist()),
        grip_force=grip_force,
    )
