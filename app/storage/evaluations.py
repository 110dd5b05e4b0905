"""Evaluations: what is measured, and one row for each attempt."""

from collections.abc import Sequence
from datetime import datetime
from typing import Any, Literal

from sqlalchemy import JSON, ForeignKey, String, Text, UniqueConstraint, func, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.domain.errors import NotThere
from app.storage.base import Base, Moment, insert_once, locked

Status = Literal["queued", "running", "succeeded", "failed", "cancelled"]
UNFINISHED: tuple[Status, ...] = ("queued", "running")


class EvaluationRow(Base):
    """One evaluation."""

    __tablename__ = "evaluations"

    serial: Mapped[int] = mapped_column(primary_key=True)
    id: Mapped[str] = mapped_column(String(32), unique=True)
    created_at: Mapped[datetime] = mapped_column(Moment)
    started_at: Mapped[datetime | None] = mapped_column(Moment)
    finished_at: Mapped[datetime | None] = mapped_column(Moment)
    status: Mapped[Status] = mapped_column(String(20), index=True)
    suite: Mapped[str] = mapped_column(String(100))
    request: Mapped[dict[str, Any]] = mapped_column(JSON)
    """What is measured, with every default filled in."""
    total: Mapped[int]
    """Attempts there are to be."""
    lanes: Mapped[int]
    """Attempts that may be under way at the same time."""
    error: Mapped[str | None] = mapped_column(Text)


class EvaluationResultRow(Base):
    """One attempt."""

    __tablename__ = "evaluation_results"
    __table_args__ = (UniqueConstraint("evaluation_id", "index"),)

    serial: Mapped[int] = mapped_column(primary_key=True)
    evaluation_id: Mapped[str] = mapped_column(ForeignKey("evaluations.id"))
    index: Mapped[int]
    """Its place among the attempts, from 0."""
    attempts: Mapped[int] = mapped_column(default=0)
    """How often a worker has taken it up and neither finished nor stopped in good order."""
    result: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))


def get(session: Session, evaluation_id: str, *, lock: bool = False) -> EvaluationRow:
    """One evaluation; with ``lock`` nobody else changes it until the transaction ends.

    Raises:
        NotThere: no evaluation has this id.
    """
    query = select(EvaluationRow).where(EvaluationRow.id == evaluation_id)
    row = session.scalar(locked(query) if lock else query)
    if row is None:
        raise NotThere("evaluation", evaluation_id)
    return row


def status_of(session: Session, evaluation_id: str) -> Status:
    """Where it stands.

    Raises:
        NotThere: no evaluation has this id.
    """
    found = session.scalar(select(EvaluationRow.status).where(EvaluationRow.id == evaluation_id))
    if found is None:
        raise NotThere("evaluation", evaluation_id)
    return found


def page(session: Session, *, before: int | None, limit: int) -> list[EvaluationRow]:
    """The newest evaluations that came before ``before``."""
    query = select(EvaluationRow).order_by(EvaluationRow.serial.desc()).limit(limit)
    if before is not None:
        query = query.where(EvaluationRow.serial < before)
    return list(session.scalars(query))


def take(session: Session, evaluation_id: str, index: int) -> EvaluationResultRow:
    """The row of an attempt, made where there is none yet."""
    new = {"evaluation_id": evaluation_id, "index": index, "attempts": 0}
    session.execute(insert_once(session, EvaluationResultRow).values(new))
    return result(session, evaluation_id, index)


def result(session: Session, evaluation_id: str, index: int) -> EvaluationResultRow:
    """One attempt.

    Raises:
        NotThere: it has not been begun.
    """
    query = select(EvaluationResultRow).where(
        EvaluationResultRow.evaluation_id == evaluation_id, EvaluationResultRow.index == index
    )
    row = session.scalar(query)
    if row is None:
        raise NotThere("result", f"{evaluation_id}/{index}")
    return row


def results(
    session: Session, evaluation_id: str, *, after: int = -1, limit: int | None = None
) -> Sequence[EvaluationResultRow]:
    """The finished attempts, in order."""
    query = (
        select(EvaluationResultRow)
        .where(
            EvaluationResultRow.evaluation_id == evaluation_id,
            EvaluationResultRow.result.is_not(None),
            EvaluationResultRow.index > after,
        )
        .order_by(EvaluationResultRow.index)
    )
    return session.scalars(query if limit is None else query.limit(limit)).all()


def count_done(session: Session, evaluation_id: str) -> int:
    """How many attempts are finished."""
    query = select(func.count()).where(
        EvaluationResultRow.evaluation_id == evaluation_id,
        EvaluationResultRow.result.is_not(None),
    )
    return session.scalar(query) or 0
