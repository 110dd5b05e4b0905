"""Plans: ask for one, read it, follow it, carry it out, stop it."""

from typing import Annotated

from fastapi import APIRouter, Header, Query, Response
from sqlalchemy.orm import Session

from app.api.paging import Cursor, Limit, part, position
from app.api.parts import Parts, Using
from app.api.schemas.base import Page
from app.api.schemas.executions import ExecutionShown, show_execution
from app.api.schemas.plans import ExecutionGiven, PlanGiven, PlanShown, show_plan
from app.api.streams import Ending, event_stream
from app.api.submission import submit
from app.api.what_if import changed_execution
from app.api.writing import written
from app.domain.errors import Conflict
from app.storage import events, executions, plans
from app.storage.base import now
from app.storage.events import EventRow
from app.storage.handover import execution_of
from app.storage.plans import PlanRow, Status

router = APIRouter(prefix="/plans", tags=["plans"])

Key = Annotated[
    str | None,
    Header(
        min_length=1,
        max_length=255,
        description="Makes the request safe to repeat: the same key, the same plan.",
    ),
]


@router.post("", status_code=202, response_model=PlanShown)
def create_plan(request: PlanGiven, parts: Using, idempotency_key: Key = None) -> Response:
    """Ask for a plan; it is made, and carried out, while the answer is already here."""
    row = submit(parts, request, idempotency_key)
    return _accepted(parts, row)


@router.get("", response_model=Page)
def list_plans(
    parts: Using,
    limit: Limit = 20,
    cursor: Cursor = None,
    status: Annotated[Status | None, Query(description="Only plans of this status.")] = None,
) -> Response:
    """Plans, newest first."""
    with parts.database.reading() as session:
        rows = plans.page(session, before=position(cursor), limit=limit + 1, status=status)
        of_plans = executions.of_plans(session, [row.id for row in rows])
    return part(rows, limit, lambda row: show_plan(row, of_plans[row.id]))


@router.get("/{plan_id}", response_model=PlanShown)
def read_plan(plan_id: str, parts: Using) -> Response:
    """One plan, with everything that came of it so far."""
    with parts.database.reading() as session:
        return written(_shown(session, plans.get(session, plan_id)))


@router.get("/{plan_id}/events", response_class=Response)
async def follow_plan(
    plan_id: str, parts: Using, last_event_id: Annotated[str | None, Header()] = None
) -> Response:
    """The events of its planning as Server-Sent Events, until the planning is over."""

    def read(last: int) -> tuple[Ending, list[EventRow]]:
        with parts.database.reading() as session:
            row = plans.get(session, plan_id)
            ids = [execution_id for execution_id, _ in executions.of_plan(session, plan_id)]
            over = row.status not in ("queued", "planning")
            ending = {"status": row.status, "executions": ids} if over else None
            return ending, events.after(session, plan_id, last)

    return await event_stream(parts.tail, read, last_event_id)


@router.post("/{plan_id}/executions", status_code=202, response_model=ExecutionShown)
def execute_plan(plan_id: str, parts: Using, request: ExecutionGiven | None = None) -> Response:
    """Carry the plan out once more, or for the first time where it was only planned.

    With anything changed it is a what-if, which leaves the plan's status as it is.
    """
    with parts.database.reading() as session:
        row = plans.get(session, plan_id)
        wanted = changed_execution(session, row, request or ExecutionGiven())
    with parts.database.transaction() as session:
        row = plans.get(session, plan_id, lock=True)
        _must_be_runnable(row)
        execution = parts.handover.approved(session, row, wanted)
        shown = show_execution(execution, row, [])
    return written(shown, 202, {"Location": f"/executions/{execution.id}"})


@router.post("/{plan_id}/approve", status_code=202, response_model=PlanShown)
def approve_plan(plan_id: str, parts: Using) -> Response:
    """Let a plan that awaits approval be carried out."""
    with parts.database.transaction() as session:
        row = plans.get(session, plan_id, lock=True)
        if row.status != "awaiting_approval":
            raise Conflict(f"the plan is {row.status}; only one that awaits approval can get it")
        parts.handover.approved(session, row, execution_of(session, row))
        return written(_shown(session, row), 202)


@router.post("/{plan_id}/cancel", status_code=202, response_model=PlanShown)
def cancel_plan(plan_id: str, parts: Using) -> Response:
    """Stop planning, or carrying out; what happened until then is kept.

    Whoever plans cannot always be heard at once, as while a model is loaded: the plan does not wait.
    """
    with parts.database.transaction() as session:
        row = plans.get(session, plan_id, lock=True)
        if row.status in ("queued", "planning", "awaiting_approval"):
            row.status, row.finished_at = "cancelled", now()
        elif row.status not in ("executing", "cancelled"):
            raise Conflict(f"the plan is {row.status} already")
        executions.request_cancel(session, plan_id)
        row.cancel_requested = True
        session.flush()
        return written(_shown(session, row), 202)


def _must_be_runnable(row: PlanRow) -> None:
    if row.program is None or row.status in ("queued", "planning"):
        raise Conflict(f"the plan is {row.status} and has no program to carry out")
    if row.status == "awaiting_approval":
        raise Conflict("the plan awaits approval: POST /plans/{id}/approve")


def _shown(session: Session, row: PlanRow) -> PlanShown:
    return show_plan(row, [found for found, _ in executions.of_plan(session, row.id)])


def _accepted(parts: Parts, row: PlanRow) -> Response:
    with parts.database.reading() as session:
        shown = _shown(session, row)
    return written(shown, 202, {"Location": f"/plans/{row.id}"})
