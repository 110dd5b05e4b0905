"""GCR: the share of the goal conditions that hold at the end."""

from app.domain.trace import GoalChecked, Trace
from app.scores import scores


@scores.register("gcr")
class GoalConditionRecall:
    """GCR = 1 - |unmet goal conditions| / |goal conditions|; SR is 1 exactly where GCR is."""

    def __call__(self, trace: Trace) -> float | None:
        """GCR of one execution, or None where no goal was checked."""
        checked = [event.holds for event in trace.events if isinstance(event, GoalChecked)]
        return sum(checked) / len(checked) if checked else None
