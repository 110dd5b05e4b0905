"""Checkpoints: the states of a world between the steps of an execution, and at its end."""

from sqlalchemy import ForeignKey, LargeBinary, UniqueConstraint, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.storage.base import Base

END = 2**31 - 1
"""The step of the state in which an execution left its world."""


class CheckpointRow(Base):
    """One state that a world can take up again."""

    __tablename__ = "checkpoints"
    __table_args__ = (UniqueConstraint("execution_id", "step"),)

    serial: Mapped[int] = mapped_column(primary_key=True)
    execution_id: Mapped[str] = mapped_column(ForeignKey("executions.id"))
    step: Mapped[int]
    """The step of the plan that comes next."""
    state: Mapped[bytes] = mapped_column(LargeBinary)
    """The world's own (``World.save``)."""


def put(session: Session, execution_id: str, step: int, state: bytes) -> None:
    """Keep a state; a run that is taken up again comes to the same one."""
    query = select(CheckpointRow).where(
        CheckpointRow.execution_id == execution_id, CheckpointRow.step == step
    )
    row = session.scalar(query)
    if row is None:
        session.add(CheckpointRow(execution_id=execution_id, step=step, state=state))
    else:
        row.state = state


def before(session: Session, execution_id: str, step: int) -> bytes | None:
    """The last state before ``step`` ran; None where that is the execution's beginning."""
    query = (
        select(CheckpointRow.state)
        .where(CheckpointRow.execution_id == execution_id, CheckpointRow.step <= step)
        .order_by(CheckpointRow.step.desc())
        .limit(1)
    )
    return session.scalar(query)
