"""Dialogue: the plans that came before one, and the state of things they left behind."""

from sqlalchemy import exists, select
from sqlalchemy.orm import Session

from app.storage import plans
from app.storage.checkpoints import CheckpointRow
from app.storage.executions import OWN, ExecutionRow
from app.storage.plans import PlanRow

MAX_TURNS = 8
"""How far back a planner is told of."""


def turns(session: Session, plan: PlanRow) -> list[PlanRow]:
    """The plans this one follows, oldest first, the nearest ``MAX_TURNS`` of them."""
    found: list[PlanRow] = []
    while plan.parent is not None and len(found) < MAX_TURNS:
        plan = plans.get(session, plan.parent)
        found.append(plan)
    return found[::-1]


def beginning(session: Session, plan: PlanRow) -> str | None:
    """Id of the execution whose end is where the plan begins; None for the scene as described.

    A plan made anew goes on where its last try ended, any other where its parent left off.
    """
    if plan.tries:
        return plan.tries[-1]["execution"]
    return last_execution(session, plans.get(session, plan.parent)) if plan.parent else None


def last_execution(session: Session, plan: PlanRow | None) -> str | None:
    """Id of the execution that left things as they stand after the plan, if there was any.

    Only the plan's own runs move things for good, and of those only the ones that came so far as
    to keep a state: a run cancelled in the queue leaves everything where the one before put it.
    """
    while plan is not None:
        query = (
            select(ExecutionRow.id)
            .where(ExecutionRow.plan_id == plan.id, OWN)
            .where(ExecutionRow.status.in_(("succeeded", "failed", "cancelled")))
            .where(exists().where(CheckpointRow.execution_id == ExecutionRow.id))
            .order_by(ExecutionRow.serial.desc())
            .limit(1)
        )
        if last := session.scalar(query):
            return last
        plan = plans.get(session, plan.parent) if plan.parent else None
    return None
