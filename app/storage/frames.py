"""Frames: how everything stood, moment by moment, as packed numbers."""

import struct
from collections.abc import Sequence

from sqlalchemy import ForeignKey, LargeBinary, UniqueConstraint, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.domain.trace import Frame
from app.storage.base import Base


class FramesRow(Base):
    """Some consecutive frames of an execution."""

    __tablename__ = "frames"
    __table_args__ = (UniqueConstraint("execution_id", "first"),)

    serial: Mapped[int] = mapped_column(primary_key=True)
    execution_id: Mapped[str] = mapped_column(ForeignKey("executions.id"))
    first: Mapped[int]
    """Index of the first frame of this row."""
    count: Mapped[int]
    width: Mapped[int]
    """Numbers per frame: 1 + nq."""
    data: Mapped[bytes] = mapped_column(LargeBinary)
    """Little-endian float32, shape (count, width): the time [s], then qpos [m] and [rad]."""


def append(session: Session, execution_id: str, first: int, frames: Sequence[Frame]) -> None:
    """Write the frames with the indices ``first``, ``first + 1`` …; those already there stay."""
    known = count(session, execution_id)
    fresh = frames[max(0, known - first) :]
    if not fresh:
        return
    width = 1 + len(fresh[0].positions)
    row = struct.Struct(f"<{width}f")
    session.add(
        FramesRow(
            execution_id=execution_id,
            first=max(first, known),
            count=len(fresh),
            width=width,
            data=b"".join(row.pack(frame.time, *frame.positions) for frame in fresh),
        )
    )


def count(session: Session, execution_id: str) -> int:
    """How many frames are there."""
    query = (
        select(FramesRow.first + FramesRow.count)
        .where(FramesRow.execution_id == execution_id)
        .order_by(FramesRow.first.desc())
        .limit(1)
    )
    return session.scalar(query) or 0


def read(session: Session, execution_id: str, start: int = 0) -> tuple[bytes, int]:
    """The frames from index ``start`` on, packed as in ``FramesRow.data``, and their width."""
    query = (
        select(FramesRow)
        .where(FramesRow.execution_id == execution_id, FramesRow.first + FramesRow.count > start)
        .order_by(FramesRow.first)
    )
    rows = list(session.scalars(query))
    if not rows:
        return b"", 0
    width = rows[0].width
    skipped = max(0, start - rows[0].first)
    return b"".join(row.data for row in rows)[skipped * width * 4 :], width
