"""Outcome: what a finished execution amounts to, and why."""

from dataclasses import dataclass
from typing import Any, Literal

from app.domain.trace import (
    ActionFailed,
    CallSkipped,
    ExecutionEvent,
    ExecutionFinished,
    GoalChecked,
)
from app.programs.conditions import print_condition
from app.rollout import Scores


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """How an execution ended."""

    status: Literal["succeeded", "failed", "cancelled"]
    error: str | None = None
    """Why it did not succeed, in a sentence."""
    failure: dict[str, Any] | None = None
    """The first step that failed: line, stage, reason."""
    observed: str = ""
    """What went wrong as a planner may learn it: the failed steps, never the goal conditions."""
    scores: Scores | None = None
    final_state: list[str] | None = None


def outcome(events: tuple[ExecutionEvent, ...], scores: Scores) -> Outcome:
    """Succeeded where every goal condition holds or, without a goal, every step was performed."""
    failures = [event for event in events if isinstance(event, ActionFailed | CallSkipped)]
    unmet = [event for event in events if isinstance(event, GoalChecked) and not event.holds]
    has_goal = any(isinstance(event, GoalChecked) for event in events)
    good = not unmet if has_goal else not failures
    reasons = (
        [f"not reached: {', '.join(print_condition(event.condition) for event in unmet)}"]
        if unmet
        else []
    )
    reasons += [_reason(event) for event in failures]
    finished = [event for event in events if isinstance(event, ExecutionFinished)]
    return Outcome(
        status="succeeded" if good else "failed",
        error=None if good else "; ".join(reasons),
        failure=_failure(failures[0]) if failures else None,
        observed="" if good else "; ".join(map(_reason, failures)),
        scores=scores,
        final_state=sorted(print_condition(fact) for fact in finished[-1].facts)
        if finished
        else None,
    )


def _failure(event: ActionFailed | CallSkipped) -> dict[str, Any]:
    stage = event.stage if isinstance(event, ActionFailed) else "grounding"
    return {"line": event.line, "stage": stage, "reason": event.reason}


def _reason(event: ActionFailed | CallSkipped) -> str:
    found = _failure(event)
    return f"line {found['line']}, {found['stage']}: {found['reason']}"
