"""Score: one number in [0, 1] read from the trace of an execution."""

from typing import Protocol

from app.domain.trace import Trace


class Scorer(Protocol):
    """One of the paper's metrics."""

    def __call__(self, trace: Trace) -> float | None:
        """The score, in [0, 1], or None where the trace does not say (no goal was given)."""
        ...
