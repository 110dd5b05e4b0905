"""Executions: one program run once, from the start of its scene or from where another left off."""

from collections.abc import Collection
from datetime import datetime
from typing import Any, Literal

from sqlalchemy import (
    JSON,
    BigInteger,
    ForeignKey,
    String,
    Text,
    bindparam,
    func,
    select,
    update,
)
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.domain.errors import NotThere
from app.storage.base import Base, Moment, locked

Status = Literal["queued", "executing", "succeeded", "failed", "cancelled"]
UNFINISHED: tuple[Status, ...] = ("queued", "executing")


class ExecutionRow(Base):
    """One run of a plan in its world."""

    __tablename__ = "executions"

    serial: Mapped[int] = mapped_column(primary_key=True)
    id: Mapped[str] = mapped_column(String(32), unique=True)
    plan_id: Mapped[str] = mapped_column(ForeignKey("plans.id"), index=True)
    created_at: Mapped[datetime] = mapped_column(Moment)
    started_at: Mapped[datetime | None] = mapped_column(Moment)
    finished_at: Mapped[datetime | None] = mapped_column(Moment)
    status: Mapped[Status] = mapped_column(String(20), index=True)
    seed: Mapped[int] = mapped_column(BigInteger)
    scene: Mapped[dict[str, Any]] = mapped_column(JSON)
    """As its world completed it from this execution's seed."""
    program: Mapped[str] = mapped_column(Text, default="")
    """The whole function it runs; the plan's may be a later one."""
    options: Mapped[dict[str, Any]] = mapped_column(JSON, default=dict)
    """How its world is opened and who decides assertions."""
    begins_after: Mapped[str | None] = mapped_column(String(32))
    """The execution whose world it takes over; None for the scene as described."""
    begins_at_line: Mapped[int | None]
    """It takes that world over before this line of the program, and runs from there."""
    rerun_of: Mapped[str | None] = mapped_column(String(32))
    """The execution it repeats, to be compared with."""
    identical: Mapped[bool | None]
    """Whether its trace is the same, bit for bit."""
    what_if: Mapped[bool] = mapped_column(default=False)
    """Something was changed for it: seed, program or beginning are not the plan's."""

    scores: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))
    final_state: Mapped[list[str] | None] = mapped_column(JSON(none_as_null=True))
    failure: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))
    """The first step that failed: its line, stage and reason."""
    error: Mapped[str | None] = mapped_column(Text)

    attempts: Mapped[int] = mapped_column(default=0)
    """How often a worker died over it since the last checkpoint."""
    cancel_requested: Mapped[bool] = mapped_column(default=False)
    next_step: Mapped[int] = mapped_column(default=0)
    """The step that comes after its last checkpoint."""
    next_event: Mapped[int] = mapped_column(default=0)
    next_frame: Mapped[int] = mapped_column(default=0)

    @property
    def own(self) -> bool:
        """Whether it is the plan itself that is carried out, and no what-if or repetition."""
        return not self.what_if and self.rerun_of is None


OWN = ExecutionRow.what_if.is_(False) & ExecutionRow.rerun_of.is_(None)
"""``ExecutionRow.own`` in a query."""
_BY_ID = select(ExecutionRow).where(ExecutionRow.id == bindparam("id"))
_LOCKED = locked(_BY_ID)
_OF_PLAN = (
    select(ExecutionRow.id, ExecutionRow.status)
    .where(ExecutionRow.plan_id == bindparam("plan_id"))
    .order_by(ExecutionRow.serial)
)


def get(session: Session, execution_id: str, *, lock: bool = False) -> ExecutionRow:
    """One execution; with ``lock`` nobody else changes it until the transaction ends.

    Who needs its plan locked as well locks the plan first, lest two wait for each other.

    Raises:
        NotThere: no execution has this id.
    """
    row = session.scalar(_LOCKED if lock else _BY_ID, {"id": execution_id})
    if row is None:
        raise NotThere("execution", execution_id)
    return row


def of_plan(session: Session, plan_id: str) -> list[tuple[str, Status]]:
    """Ids and statuses of a plan's executions, oldest first."""
    found = session.execute(_OF_PLAN, {"plan_id": plan_id})
    return [(execution_id, status) for execution_id, status in found]


def pending(session: Session, plan_id: str) -> bool:
    """Whether an execution is left by which the plan may still come to its outcome."""
    query = select(ExecutionRow.id).where(
        ExecutionRow.plan_id == plan_id, OWN, ExecutionRow.status.in_(UNFINISHED)
    )
    return session.scalar(query.limit(1)) is not None


def of_plans(session: Session, plan_ids: Collection[str]) -> dict[str, list[str]]:
    """Ids of the executions of several plans, oldest first."""
    query = (
        select(ExecutionRow.plan_id, ExecutionRow.id)
        .where(ExecutionRow.plan_id.in_(plan_ids))
        .order_by(ExecutionRow.serial)
    )
    found: dict[str, list[str]] = {plan_id: [] for plan_id in plan_ids}
    for plan_id, execution_id in session.execute(query):
        found[plan_id].append(execution_id)
    return found


def page(
    session: Session, *, before: int | None, limit: int, plan_id: str | None = None
) -> list[ExecutionRow]:
    """The newest executions that came before ``before``."""
    query = select(ExecutionRow).order_by(ExecutionRow.serial.desc()).limit(limit)
    if before is not None:
        query = query.where(ExecutionRow.serial < before)
    if plan_id is not None:
        query = query.where(ExecutionRow.plan_id == plan_id)
    return list(session.scalars(query))


def change(
    session: Session, execution_id: str, *, when: Collection[Status], **values: object
) -> bool:
    """Set ``values`` if the execution's status is one of ``when``; False where it was not."""
    query = (
        update(ExecutionRow)
        .where(ExecutionRow.id == execution_id, ExecutionRow.status.in_(when))
        .values(**values)
    )
    return session.execute(query).rowcount > 0  # pyright: ignore[reportAttributeAccessIssue]


def cancelled(session: Session, execution_id: str) -> bool:
    """Whether somebody asked for it to stop."""
    query = select(ExecutionRow.cancel_requested).where(ExecutionRow.id == execution_id)
    return bool(session.scalar(query))


def request_cancel(session: Session, plan_id: str) -> None:
    """Ask all unfinished executions of a plan to stop."""
    session.execute(
        update(ExecutionRow)
        .where(ExecutionRow.plan_id == plan_id, ExecutionRow.status.in_(UNFINISHED))
        .values(cancel_requested=True)
    )


def count_by_status(session: Session) -> dict[str, int]:
    """How many executions there are, by status."""
    query = select(ExecutionRow.status, func.count()).group_by(ExecutionRow.status)
    return {found: number for found, number in session.execute(query)}  # noqa: C416 - rows are no plain pairs
