"""Plans: what was asked, what the model wrote, and what became of it."""

from collections.abc import Collection
from datetime import datetime
from typing import Any, Literal

from sqlalchemy import JSON, BigInteger, Double, String, Text, bindparam, func, select, update
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.domain.errors import NotThere
from app.storage.base import Base, Moment, locked

Status = Literal[
    "queued",
    "planning",
    "planned",
    "awaiting_approval",
    "executing",
    "succeeded",
    "failed",
    "cancelled",
]
UNFINISHED: tuple[Status, ...] = ("queued", "planning", "awaiting_approval", "executing")


class PlanRow(Base):
    """One request for a plan and everything that came of it."""

    __tablename__ = "plans"

    serial: Mapped[int] = mapped_column(primary_key=True)
    """Order of arrival; what lists are sorted by."""
    id: Mapped[str] = mapped_column(String(32), unique=True)
    created_at: Mapped[datetime] = mapped_column(Moment)
    started_at: Mapped[datetime | None] = mapped_column(Moment)
    """When a planner took it up."""
    finished_at: Mapped[datetime | None] = mapped_column(Moment)
    status: Mapped[Status] = mapped_column(String(20), index=True)

    idempotency_key: Mapped[str | None] = mapped_column(String(255), unique=True)
    request_digest: Mapped[str] = mapped_column(String(64))
    """SHA-256 of the request, to tell a repeated request from a different one."""

    instruction: Mapped[str] = mapped_column(Text)
    scene_id: Mapped[str | None] = mapped_column(String(32))
    given_scene: Mapped[dict[str, Any]] = mapped_column(JSON)
    """As the client described it."""
    scene: Mapped[dict[str, Any]] = mapped_column(JSON)
    """As its world completed it from the seed."""
    seed: Mapped[int] = mapped_column(BigInteger)
    execute: Mapped[bool]
    approval: Mapped[str] = mapped_column(String(10))
    goal: Mapped[list[str]] = mapped_column(JSON)
    planner: Mapped[dict[str, Any]] = mapped_column(JSON)
    """The planner's options; empty where the client wrote the program."""

    prompt: Mapped[str | None] = mapped_column(Text)
    completion: Mapped[str | None] = mapped_column(Text)
    program: Mapped[str | None] = mapped_column(Text)
    program_tree: Mapped[list[dict[str, Any]]] = mapped_column(JSON, default=list)
    steps: Mapped[list[dict[str, Any]]] = mapped_column(JSON, default=list)
    rejected: Mapped[list[dict[str, Any]]] = mapped_column(JSON, default=list)
    usage: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))
    plan_scores: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))
    error: Mapped[str | None] = mapped_column(Text)

    options: Mapped[dict[str, Any]] = mapped_column(JSON, default=dict)
    """How its world is opened: what the robot perceives."""
    parent: Mapped[str | None] = mapped_column(String(32))
    """The plan it follows in a dialogue."""
    confidence: Mapped[float | None] = mapped_column(Double)
    declined: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))
    """Why the planner would not plan it: kind, reason, question, choices."""
    replans: Mapped[int] = mapped_column(default=0)
    tries: Mapped[list[dict[str, Any]]] = mapped_column(JSON, default=list)
    """The programs before this one, each with its execution and what came of it, oldest first."""
    attempts: Mapped[int] = mapped_column(default=0)
    """How often a worker has taken it up and neither finished nor stopped in good order."""
    cancel_requested: Mapped[bool] = mapped_column(default=False)


_BY_ID = select(PlanRow).where(PlanRow.id == bindparam("id"))
"""Written once: putting a query together takes longer than SQLite takes to answer it."""
_LOCKED = locked(_BY_ID)
_STATUS = locked(select(PlanRow.status).where(PlanRow.id == bindparam("id")))


def get(session: Session, plan_id: str, *, lock: bool = False) -> PlanRow:
    """One plan; with ``lock`` nobody else changes it until the transaction ends.

    Raises:
        NotThere: no plan has this id.
    """
    row = session.scalar(_LOCKED if lock else _BY_ID, {"id": plan_id})
    if row is None:
        raise NotThere("plan", plan_id)
    return row


def several(session: Session, plan_ids: Collection[str]) -> dict[str, PlanRow]:
    """Those plans of these ids that there are, by id."""
    query = select(PlanRow).where(PlanRow.id.in_(plan_ids))
    return {row.id: row for row in session.scalars(query)}


def with_key(session: Session, idempotency_key: str) -> PlanRow | None:
    """The plan that was asked for under this key, if any."""
    return session.scalar(select(PlanRow).where(PlanRow.idempotency_key == idempotency_key))


def page(
    session: Session, *, before: int | None, limit: int, status: str | None = None
) -> list[PlanRow]:
    """The newest plans that came before ``before``."""
    query = select(PlanRow).order_by(PlanRow.serial.desc()).limit(limit)
    if before is not None:
        query = query.where(PlanRow.serial < before)
    if status is not None:
        query = query.where(PlanRow.status == status)
    return list(session.scalars(query))


def change(session: Session, plan_id: str, *, when: Collection[Status], **values: object) -> bool:
    """Set ``values`` if the plan's status is one of ``when``; False where it was not."""
    query = update(PlanRow).where(PlanRow.id == plan_id, PlanRow.status.in_(when)).values(**values)
    return session.execute(query).rowcount > 0  # pyright: ignore[reportAttributeAccessIssue]


def being_planned(session: Session, plan_id: str) -> bool:
    """Whether it is; nobody puts an end to it until the transaction ends."""
    return session.scalar(_STATUS, {"id": plan_id}) == "planning"


def count_by_status(session: Session) -> dict[str, int]:
    """How many plans there are, by status."""
    rows = session.execute(select(PlanRow.status, func.count()).group_by(PlanRow.status))
    return {found: number for found, number in rows}  # noqa: C416 - rows are no plain pairs
