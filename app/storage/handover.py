"""Handover: how a plan goes from one status, and one queue, to the next."""

from sqlalchemy.orm import Session

from app.storage import executions
from app.storage.base import new_id, now
from app.storage.executions import ExecutionRow
from app.storage.jobs import Jobs
from app.storage.plans import PlanRow


class Handover:
    """The rules of a plan's way; each call belongs to its caller's transaction."""

    def __init__(self, jobs: Jobs) -> None:
        self._jobs = jobs

    def queued(self, session: Session, plan: PlanRow) -> None:
        """A new plan waits for a planner."""
        session.flush()
        self._jobs.enqueue(session, "planning", plan.id)

    def planned(self, session: Session, plan: PlanRow) -> None:
        """Its program is ready: it is carried out, waits for approval, or rests."""
        if not plan.execute:
            plan.status = "planned"
            plan.finished_at = now()
        elif plan.approval == "manual":
            plan.status = "awaiting_approval"
        else:
            self.approved(session, plan, seed=plan.seed, scene=plan.scene)

    def approved(
        self, session: Session, plan: PlanRow, *, seed: int, scene: dict[str, object]
    ) -> ExecutionRow:
        """It may be carried out, in the given (completed) scene."""
        plan.status = "executing"
        plan.error = None
        plan.finished_at = None
        execution = ExecutionRow(
            id=new_id("ex"),
            plan_id=plan.id,
            created_at=now(),
            status="queued",
            seed=seed,
            scene=scene,
        )
        session.add(execution)
        session.flush()
        self._jobs.enqueue(session, "simulation", execution.id)
        return execution

    def executed(self, session: Session, plan: PlanRow, *, status: str, error: str | None) -> None:
        """One of its executions ended; when none is left, the plan has that one's outcome."""
        session.flush()
        left = [
            execution_id
            for execution_id, found in executions.of_plan(session, plan.id)
            if found in executions.UNFINISHED
        ]
        if not left and plan.status == "executing":
            plan.status = "cancelled" if plan.cancel_requested else status  # pyright: ignore
            plan.error = error
            plan.finished_at = now()
