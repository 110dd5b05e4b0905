"""Pose: where something is and how it is turned."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Pose:
    """A rigid motion from the robot's base frame."""

    position: tuple[float, float, float]
    """x forward, y to the robot's left, z up [m]."""
    quaternion: tuple[float, float, float, float]
    """Unit length, wxyz."""
