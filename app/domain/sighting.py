"""Sighting: where in a picture an object was found; Finder: the port to whatever finds it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol


@dataclass(frozen=True, slots=True, kw_only=True)
class Sighting:
    """One object in one picture; shares of its width and height from its top left corner."""

    name: str
    box: tuple[float, float, float, float] | None = None
    """Left, top, right, bottom, in [0, 1]."""
    point: tuple[float, float] | None = None
    """A place on it, where no box is told: across and down, in [0, 1]."""


class Finder(Protocol):
    """Finds objects of which it knows nothing but their names."""

    def find(self, picture: bytes, names: Sequence[str]) -> tuple[Sighting, ...]:
        """Those that it sees, each at most once.

        Args:
            picture: a PNG.
            names: of the objects that may be in it.

        Raises:
            ModelUnavailable: it cannot be asked.
            CompletionFailed: it gave nothing usable.
        """
        ...
