"""HouseholdReel: keys of time and coordinates; between two of them everything goes evenly."""

from bisect import bisect_left
from collections import deque

import numpy as np

from app.domain.trace import Frame

RATE = 10.0
"""Frames a second [1/s]."""


class HouseholdReel:
    """The keys from the next frame on, and the frames they make."""

    def __init__(self, coordinates: np.ndarray, units: np.ndarray) -> None:
        """Begin at time 0; a frame's positions are the coordinates times the ``units``, both (n,)."""
        self._units = units
        self.rewind(coordinates)

    def rewind(self, coordinates: np.ndarray, time: float = 0.0, following: float = 0.0) -> None:
        """Have but this key, and take the ``following`` frame next, both times in [s]."""
        self.time = time
        """When the last key is [s]."""
        self.next = following
        """When the next frame is [s]."""
        self._keys: deque[tuple[float, np.ndarray]] = deque([(time, coordinates.copy())])

    def add(self, seconds: float, coordinates: np.ndarray) -> None:
        """So long after the last key the coordinates are these."""
        self.time = round(self.time + seconds, 6)
        self._keys.append((self.time, coordinates.copy()))

    def frames(self, until: float) -> tuple[Frame, ...]:
        """The frames not yet given up to a time [s]."""
        found: list[Frame] = []
        times = [time for time, _ in self._keys]
        while self.next <= until + 1e-9:
            found.append(Frame(time=round(self.next, 6), positions=self._at(times, self.next)))
            self.next += 1 / RATE
        while len(self._keys) > 1 and self._keys[1][0] < self.next:
            self._keys.popleft()
        return tuple(found)

    def _at(self, times: list[float], moment: float) -> tuple[float, ...]:
        after = min(bisect_left(times, moment), len(times) - 1)
        (begun, one), (ended, other) = self._keys[max(after - 1, 0)], self._keys[after]
        share = (moment - begun) / (ended - begun) if ended > begun else 1.0
        mixed = one + min(max(share, 0.0), 1.0) * (other - one)
        return tuple((mixed * self._units).tolist())
