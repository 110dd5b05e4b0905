"""Robot: the port behind which a real arm stands, what it is told, and what it may never do."""

from dataclasses import dataclass
from typing import Protocol

from app.domain.errors import Fault, ProgPromptError, Refused

Joints = tuple[float, ...]
"""One number a joint, from the base to the hand: [rad], or [rad/s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointTrajectory:
    """Where the joints are to be and when; between two points they go straight."""

    times: tuple[float, ...]
    """From the start [s], increasing; n of them."""
    positions: tuple[Joints, ...]
    """[rad]; n of them."""
    openings: tuple[float, ...]
    """Between the finger tips [m]; n of them."""
    grip_force: float = 30.0
    """With which the fingers may close [N]."""

    @property
    def duration(self) -> float:
        """How long it takes [s]."""
        return self.times[-1] - self.times[0] if self.times else 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotLimits:
    """What an arm may do, whatever a plan says."""

    lowest: Joints
    highest: Joints
    """The joints' range [rad]."""
    speed: Joints
    """The most a joint turns in a second [rad/s]."""
    opening: float
    """The widest between the finger tips [m]."""
    grip_force: float
    """The most the fingers close with [N]."""
    contact_force: float
    """The most that may press on the arm from outside before it stops [N]."""
    workspace: tuple[tuple[float, float, float], tuple[float, float, float]]
    """Lowest and highest corner of the box the point between the finger tips stays in, base frame [m]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Carried:
    """What became of a trajectory that was let through."""

    points: int
    duration: float
    """[s]"""
    live: bool
    """Whether it was sent; else it was only checked."""


class TrajectoryRefused(Refused):
    """A trajectory breaks a limit; nothing of it was sent. The fault's field is the limit."""

    def __init__(self, limit: str, message: str) -> None:
        super().__init__(Fault(field=limit, message=message))


class RobotStopped(ProgPromptError):
    """A motion was broken off: the arm was told to stop, or could no longer be told anything."""


class Robot(Protocol):
    """An arm with a gripper."""

    limits: RobotLimits

    def execute(self, trajectory: JointTrajectory) -> Carried:
        """Go along the trajectory to its end.

        Raises:
            TrajectoryRefused: it breaks a limit; nothing was sent.
            RobotStopped: it was broken off on the way.
        """
        ...
