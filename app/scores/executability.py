"""Exec: the share of the attempted actions that could be carried out."""

from app.domain.trace import ActionFailed, ActionPerformed, CallSkipped, Trace
from app.scores import scores


@scores.register("exec")
class Executability:
    """Exec = performed / attempted, whether or not they serve the task.

    Attempted are all calls whose turn came: recoveries that were taken and calls that name what is
    not there count, recoveries that were not needed do not.
    """

    def __call__(self, trace: Trace) -> float | None:
        """Exec of one execution, or None where it attempted nothing."""
        performed = sum(isinstance(event, ActionPerformed) for event in trace.events)
        attempted = performed + sum(
            isinstance(event, ActionFailed | CallSkipped) for event in trace.events
        )
        return performed / attempted if attempted else None
