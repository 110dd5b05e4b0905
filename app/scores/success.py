"""SR: whether every goal condition holds at the end."""

from app.domain.trace import GoalChecked, Trace
from app.scores import scores


@scores.register("sr")
class Success:
    """1 where all goal conditions hold, else 0; a rate is the mean over executions."""

    def __call__(self, trace: Trace) -> float | None:
        """SR of one execution, or None where no goal was checked."""
        checked = [event.holds for event in trace.events if isinstance(event, GoalChecked)]
        return float(all(checked)) if checked else None
