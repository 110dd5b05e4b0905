"""Handover: how a plan goes from one status, and one queue, to the next."""

from sqlalchemy.orm import Session

from app.storage import dialogue, executions
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
            self.approved(session, plan, execution_of(session, plan))

    def approved(self, session: Session, plan: PlanRow, execution: ExecutionRow) -> ExecutionRow:
        """The plan may be carried out, in this way; what-ifs and repetitions leave it as it is."""
        if execution.own:
            plan.cancel_requested = plan.cancel_requested and plan.status == "executing"
            plan.status = "executing"
            plan.error = None
            plan.finished_at = None
        session.add(execution)
        session.flush()
        self._jobs.enqueue(session, "simulation", execution.id)
        return execution

    def may_replan(self, plan: PlanRow, execution: ExecutionRow) -> bool:
        """Whether the plan is to be made anew after this execution of it failed."""
        wanted = plan.replans < plan.planner.get("max_replans", 0) and not plan.cancel_requested
        return wanted and execution.own and execution.program == plan.program

    def replan(self, session: Session, plan: PlanRow, execution_id: str, outcome: str) -> None:
        """What is left of the plan is planned anew, from where this execution left its world."""
        tried = {"program": plan.program, "execution": execution_id, "outcome": outcome}
        plan.tries = [*plan.tries, tried]
        plan.replans += 1
        plan.status = "queued"
        plan.attempts = 0
        session.flush()
        self._jobs.enqueue(session, "planning", plan.id, job=f"{plan.id}-{plan.replans}")

    def executed(
        self,
        session: Session,
        plan: PlanRow,
        execution: ExecutionRow,
        *,
        status: str,
        error: str | None,
    ) -> None:
        """An execution ended; when none of the plan's own is left, it has that one's outcome."""
        session.flush()
        if not execution.own or plan.status != "executing":
            return
        if not executions.pending(session, plan.id):
            plan.status = "cancelled" if plan.cancel_requested else status  # pyright: ignore
            plan.error = error
            plan.finished_at = now()


def execution_of(session: Session, plan: PlanRow) -> ExecutionRow:
    """A new execution of the plan, as it was asked for; not stored yet."""
    return ExecutionRow(
        id=new_id("ex"),
        plan_id=plan.id,
        created_at=now(),
        status="queued",
        seed=plan.seed,
        scene=plan.scene,
        program=plan.program or "",
        options={**plan.options, "state_check": plan.planner.get("state_check", "world")},
        begins_after=dialogue.beginning(session, plan),
    )
