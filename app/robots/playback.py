"""Playback: an execution's frames as a trajectory for a real arm."""

import numpy as np

from app.domain.errors import Fault, Refused
from app.domain.robot import JointTrajectory
from app.robots.arm_model import ArmModel


def trajectory_of(
    packed: bytes, width: int, arm: ArmModel, *, grip_force: float = 30.0
) -> JointTrajectory:
    """What the arm did in these frames, as a service gives them: time [s], then all positions.

    Args:
        packed: little-endian float32, shape (n, width).
        width: numbers of a frame.
        arm: which arm it was.
        grip_force: with which the fingers are to close [N].

    Raises:
        Refused: they are no frames of the tabletop, or too few.
    """
    if width <= arm.finger_part.stop:
        message = "are none of a robot arm; only what was carried out on the tabletop can be sent"
        raise Refused(Fault(field="frames", message=message))
    frames = np.frombuffer(packed, "<f4").reshape(-1, width).astype(float)
    later = np.diff(frames[:, 0], prepend=-np.inf) > 0  # a frame is told twice where steps meet
    frames = frames[later]
    places = frames[:, 1:]
    fingers = places[:, arm.finger_part]
    return JointTrajectory(
        times=tuple((frames[:, 0] - frames[:1, 0]).tolist()),
        positions=tuple(tuple(row) for row in places[:, arm.arm_part].tolist()),
        openings=tuple(max(2 * arm.opening_at(row), 0.0) for row in fingers),
        grip_force=grip_force,
    )
