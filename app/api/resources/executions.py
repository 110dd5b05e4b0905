"""Executions: read one, follow it, see it, stop it."""

from collections.abc import Sequence
from typing import Annotated

from fastapi import APIRouter, Header, Query, Response
from sqlalchemy.orm import Session

from app.api.paging import MOST, Cursor, Limit, part, position
from app.api.parts import Using
from app.api.rollouts import StoredRollout
from app.api.schemas.base import Page
from app.api.schemas.executions import STEP_KINDS, ExecutionShown, show_execution
from app.api.schemas.trace import event_view
from app.api.streams import Ending, event_stream
from app.api.what_if import repeated
from app.api.writing import written
from app.domain.errors import Conflict
from app.storage import events, executions, frames, plans
from app.storage.base import now
from app.storage.events import EventRow
from app.storage.executions import ExecutionRow
from app.view.recording import record_rollout

router = APIRouter(prefix="/executions", tags=["executions"])


@router.get("", response_model=Page)
def list_executions(
    parts: Using,
    limit: Limit = 20,
    cursor: Cursor = None,
    plan_id: Annotated[str | None, Query(max_length=32, description="Only of this plan.")] = None,
) -> Response:
    """Executions, newest first."""
    with parts.database.reading() as session:
        before = position(cursor)
        rows = executions.page(session, before=before, limit=limit + 1, plan_id=plan_id)
        shown = {row.id: view for row, view in zip(rows, _shown(session, rows), strict=True)}
    return part(rows, limit, lambda row: shown[row.id])


@router.get("/{execution_id}", response_model=ExecutionShown)
def read_execution(execution_id: str, parts: Using) -> Response:
    """One execution: its steps so far, its scores, how everything stands at the end."""
    with parts.database.reading() as session:
        [shown] = _shown(session, [executions.get(session, execution_id)])
    return written(shown)


@router.get("/{execution_id}/trace", response_model=Page)
def read_trace(
    execution_id: str,
    parts: Using,
    limit: Annotated[int, Query(ge=1, le=1000, description="Events of one part.")] = 200,
    cursor: Cursor = None,
) -> Page:
    """Its events in the order they happened."""
    after = position(cursor)
    with parts.database.reading() as session:
        executions.get(session, execution_id)
        last = -1 if after is None else after
        rows = events.after(session, execution_id, last, limit=limit + 1)
    more = len(rows) > limit
    return Page(
        items=[event_view(row) for row in rows[:limit]],
        next=str(rows[limit - 1].sequence) if more else None,
    )


@router.get("/{execution_id}/events", response_class=Response)
async def follow_execution(
    execution_id: str, parts: Using, last_event_id: Annotated[str | None, Header()] = None
) -> Response:
    """Its events as Server-Sent Events, until it has ended."""

    def read(last: int) -> tuple[Ending, list[EventRow]]:
        with parts.database.reading() as session:
            row = executions.get(session, execution_id)
            over = row.status not in executions.UNFINISHED
            ending = {"status": row.status, "plan_id": row.plan_id} if over else None
            return ending, events.after(session, execution_id, last)

    return await event_stream(parts.tail, read, last_event_id)


@router.get("/{execution_id}/frames", response_class=Response)
def read_frames(
    execution_id: str,
    parts: Using,
    start: Annotated[int, Query(ge=0, le=MOST, description="Index of the first frame.")] = 0,
) -> Response:
    """How everything stood, moment by moment.

    Little-endian float32, row by row; each row is the simulated time [s] and the simulator's
    generalized coordinates [m] and [rad]. `Frame-Width` tells the numbers of a row.
    """
    with parts.database.reading() as session:
        executions.get(session, execution_id)
        data, width = frames.read(session, execution_id, start)
    count = len(data) // (4 * width) if width else 0
    headers = {"Frame-Width": str(width), "Frame-Count": str(count), "Frame-Start": str(start)}
    return Response(data, headers=headers, media_type="application/octet-stream")


@router.get("/{execution_id}/recording", response_class=Response)
def read_recording(execution_id: str, parts: Using) -> Response:
    """A `.viser` file of the rollout so far, which plays in a browser."""
    rollout = StoredRollout(parts.database, execution_id)
    data = record_rollout(rollout)
    name = f'attachment; filename="{execution_id}.viser"'
    return Response(
        data, headers={"Content-Disposition": name}, media_type="application/octet-stream"
    )


@router.post("/{execution_id}/rerun", status_code=202)
def rerun_execution(execution_id: str, parts: Using, response: Response) -> ExecutionShown:
    """Do the same once more, and tell in `identical` whether the same happened."""
    with parts.database.transaction() as session:
        row = executions.get(session, execution_id)
        plan = plans.get(session, row.plan_id, lock=True)
        if row.status in executions.UNFINISHED:
            raise Conflict(f"the execution is {row.status}; it can be repeated once it has ended")
        again = parts.handover.approved(session, plan, repeated(row))
        response.headers["Location"] = f"/executions/{again.id}"
        return show_execution(again, plan, [])


@router.post("/{execution_id}/cancel", status_code=202)
def cancel_execution(execution_id: str, parts: Using) -> ExecutionShown:
    """Stop it; what happened until then is kept."""
    with parts.database.transaction() as session:
        plan_id = executions.get(session, execution_id).plan_id
        plan = plans.get(session, plan_id, lock=True)
        row = executions.get(session, execution_id, lock=True)
        if row.status == "queued":
            row.status, row.finished_at = "cancelled", now()
            parts.handover.executed(session, plan, row, status="cancelled", error=None)
        elif row.status not in ("executing", "cancelled"):
            raise Conflict(f"the execution is {row.status} already")
        row.cancel_requested = True
        [shown] = _shown(session, [row])
        return shown


def _shown(session: Session, rows: Sequence[ExecutionRow]) -> list[ExecutionShown]:
    asked = plans.several(session, {row.plan_id for row in rows})
    told = events.of_kinds(session, [row.id for row in rows], STEP_KINDS)
    return [show_execution(row, asked[row.plan_id], told[row.id]) for row in rows]
