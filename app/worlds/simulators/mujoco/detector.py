"""Detector: which object each pixel of a camera shows."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Labels = NDArray[np.int32]

SOMETHING_ELSE = -2
"""The label of what is no object of the scene: the table, the arm."""


class Detector(Protocol):
    """Labels pixels."""

    def label(self, bodies: Labels, points: Array) -> Labels:
        """What each pixel shows.

        Args:
            bodies: the simulator's segmentation: ids of the bodies hit, shape (n,).
            points: where they were hit, base frame, shape (n, 3) [m].

        Returns:
            The objects' places in scene order, or ``SOMETHING_ELSE``, shape (n,).
        """
        ...


class Segmentation:
    """Knows every object: the simulator's own segmentation."""

    def __init__(self, objects: Sequence[Sequence[int]], count: int) -> None:
        """Make its table.

        Args:
            objects: ids of each object's bodies, in scene order.
            count: of all bodies there are.
        """
        self._table = np.full(count, SOMETHING_ELSE, np.int32)
        for index, bodies in enumerate(objects):
            self._table[list(bodies)] = index

    def label(self, bodies: Labels, points: Array) -> Labels:
        """What each pixel shows; see ``Detector``."""
        del points  # Unused.
        return self._table[bodies]


class Confused:
    """Takes some objects for one another, always the same ones."""

    def __init__(self, detector: Detector, objects: int, rate: float, seed: int) -> None:
        """Draw who is taken for whom.

        Args:
            detector: what would be seen without confusion.
            objects: how many there are in the scene.
            rate: the probability with which each of the pairs is swapped that the objects are
                divided into at random, in [0, 1].
            seed: of everything that is drawn.
        """
        self._detector = detector
        rng = np.random.default_rng((seed, _CONFUSION))
        order = rng.permutation(objects)
        self._mistaken = np.arange(objects, dtype=np.int32)
        for first, second in zip(order[::2], order[1::2], strict=False):
            if rng.random() < rate:
                self._mistaken[[first, second]] = second, first

    def label(self, bodies: Labels, points: Array) -> Labels:
        """What each pixel seems to show; see ``Detector``."""
        labels = self._detector.label(bodies, points)
        return np.where(labels >= 0, self._mistaken[np.maximum(labels, 0)], labels)


_CONFUSION = 3
"""Keeps the stream of random numbers for confusions apart from others of the same seed."""
