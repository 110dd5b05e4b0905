"""Screening: one rollout as one page watches it."""

import asyncio
import contextlib
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass

from app.view.film import Film
from app.view.playhead import Mode, Playhead

LONGEST_TICK = 0.25
"""A watcher who was away longer comes back to where they left [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """What a page is told of its screening."""

    time: float
    """The moment shown [s]."""
    duration: float
    """How much of the rollout is known [s]."""
    mode: Mode
    speed: float
    finished: bool
    """Whether no more will be known."""
    drawn: bool
    """Whether a browser has the scene, and is sent its changes."""

    def as_dict(self) -> dict[str, float | str | bool]:
        """The same, ready for JSON."""
        return asdict(self) | {"time": round(self.time, 3), "duration": round(self.duration, 3)}


class Screening:
    """A film and a playhead; lives in the service's event loop."""

    def __init__(self, film: Film) -> None:
        self.film = film
        self.footage = film.footage
        self._views = 0
        self._playhead = Playhead()
        self._ticked_at = time.monotonic()
        self._moved = asyncio.Event()

    @contextlib.contextmanager
    def drawing(self) -> Iterator[None]:
        """While a 3D view has the scene."""
        self._views += 1
        try:
            yield
        finally:
            self._views -= 1

    async def tick(self) -> float:
        """Let the time since the last tick pass; the moment of the picture to show now [s]."""
        if self.footage.due:
            await asyncio.to_thread(self.footage.refresh)
        now = time.monotonic()
        passed = min(now - self._ticked_at, LONGEST_TICK)
        self._ticked_at = now
        end, finished = self.footage.duration, self.footage.finished
        self._playhead.advance(passed, end=end, finished=finished)
        return self.film.moment(self._playhead.time, self._playhead.speed)

    async def rest(self, playing: float, still: float) -> None:
        """Wait ``playing`` [s], or ``still`` [s] if paused; a move of the playhead wakes."""
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(still if self._playhead.mode == "paused" else playing):
                await self._moved.wait()
        self._moved.clear()

    def moment(self) -> Moment:
        """Where the playhead is."""
        return Moment(
            time=self._playhead.time,
            duration=self.footage.duration,
            mode=self._playhead.mode,
            speed=self._playhead.speed,
            finished=self.footage.finished,
            drawn=self._views > 0,
        )

    def turn(self, mode: Mode) -> None:
        """Play, pause or follow."""
        match mode:
            case "playing":
                self._playhead.play(end=self.footage.duration, finished=self.footage.finished)
            case "paused":
                self._playhead.pause()
            case "following":
                self._playhead.follow()
        self._moved.set()

    def seek(self, moment: float) -> None:
        """Jump to ``moment`` [s]."""
        self._playhead.seek(moment)
        self._moved.set()

    def set_speed(self, speed: float) -> None:
        """Play at so many seconds per second."""
        self._playhead.set_speed(speed)
        self._moved.set()
