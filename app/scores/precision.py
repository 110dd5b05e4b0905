"""Precision: how much of what should have stayed as it was did stay."""

from app.domain.condition import relations
from app.domain.trace import ExecutionFinished, ExecutionStarted, GoalChecked, Trace
from app.scores import scores


@scores.register("precision")
class Precision:
    """Of the facts that were true at the start and that the task leaves alone, those still true.

    The first argument of every relation in the goal counts as moved by the task (in
    ``in(banana, bowl)`` the banana, not the bowl); a fact that speaks of a moved object is left
    out. Where no fact is left there was nothing to disturb, and the precision is 1. Only facts the
    world tells are seen: an object pushed along the table without a fact changing is not.
    """

    def __call__(self, trace: Trace) -> float | None:
        """Precision of one execution, or None where no goal was checked or it did not finish."""
        conditions = [each.condition for each in trace.events if isinstance(each, GoalChecked)]
        before = [event.facts for event in trace.events if isinstance(event, ExecutionStarted)]
        after = [event.facts for event in trace.events if isinstance(event, ExecutionFinished)]
        if not conditions or not before or not after:
            return None
        moved = {
            relation.arguments[0]
            for condition in conditions
            for relation in relations(condition)
            if relation.arguments
        }
        untouched = {fact for fact in before[0] if moved.isdisjoint(fact.arguments)}
        return len(untouched & set(after[-1])) / len(untouched) if untouched else 1.0
