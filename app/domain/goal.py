"""Goal: what must hold when the work is done. The planner never sees it."""

from dataclasses import dataclass

from app.domain.condition import Condition


@dataclass(frozen=True, slots=True)
class Goal:
    """The goal conditions; all of them must hold at the end."""

    conditions: tuple[Condition, ...] = ()
