"""Playhead: which moment of a rollout is shown, and how it goes on."""

from dataclasses import dataclass
from typing import Literal

Mode = Literal["playing", "paused", "following"]
SLOWEST, FASTEST = 0.1, 8.0


@dataclass(slots=True, kw_only=True)
class Playhead:
    """A moment of a rollout that may still grow while it is played.

    A rollout is simulated faster than real time, so watching it live is playing a recording that
    grows: at its end the playhead waits for more, until the rollout is finished.
    """

    time: float = 0.0
    """The moment shown [s]."""
    mode: Mode = "playing"
    """``following`` shows the newest frame there is, as fast as they come."""
    speed: float = 1.0
    """Seconds of the rollout per second of the watcher."""

    def advance(self, seconds: float, *, end: float, finished: bool) -> None:
        """Let ``seconds`` pass for the watcher of a rollout known up to ``end`` [s]."""
        if self.mode == "following":
            self.time = end
        elif self.mode == "playing":
            self.time += seconds * self.speed
        self.time = min(max(self.time, 0.0), end)
        if finished and self.mode != "paused" and self.time >= end:
            self.mode = "paused"

    def play(self, *, end: float, finished: bool) -> None:
        """Go on from here, or from the start where the rollout is over."""
        if finished and self.time >= end:
            self.time = 0.0
        self.mode = "playing"

    def pause(self) -> None:
        """Stay here."""
        self.mode = "paused"

    def follow(self) -> None:
        """Show the newest frame there is."""
        self.mode = "following"

    def seek(self, time: float) -> None:
        """Jump to a moment [s]; a playhead that followed stays where it was put."""
        self.time = max(time, 0.0)
        if self.mode == "following":
            self.mode = "playing"

    def set_speed(self, speed: float) -> None:
        """Play at so many seconds per second."""
        self.speed = min(max(speed, SLOWEST), FASTEST)
