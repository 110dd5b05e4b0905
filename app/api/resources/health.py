"""Health: whether the service is there, and whether a plan can be made."""

from fastapi import APIRouter, Response

from app.api.errors import Problem
from app.api.parts import Using
from app.storage import workers
from app.storage.jobs import QUEUES

router = APIRouter(tags=["health"])


@router.get("/healthz")
def read_health() -> dict[str, str]:
    """The service is there."""
    return {"status": "ok"}


@router.get("/readyz", response_model=None)
def read_readiness(parts: Using) -> Response | dict[str, object]:
    """200 once a plan can be made and carried out; else 503, with what it waits for."""
    with parts.database.reading() as session:
        waiting = workers.waits_for(session, QUEUES)
        details = {worker.id: worker.detail for worker in workers.alive(session)}
    if not waiting:
        return {"status": "ready", "workers": details}
    detail = f"waiting for {'; '.join(waiting)}"
    return Problem(503, detail, kind="not-ready", waiting_for=waiting)
