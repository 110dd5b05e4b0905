"""Workers: who is alive, and whether they can work yet."""

from collections.abc import Collection
from datetime import datetime, timedelta

from sqlalchemy import String, Text, delete, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.storage.base import Base, Moment, now

STALE = timedelta(seconds=10)
"""A worker that has not been heard of for so long counts as gone."""


class WorkerRow(Base):
    """One worker process."""

    __tablename__ = "workers"

    id: Mapped[str] = mapped_column(String(64), primary_key=True)
    queue: Mapped[str] = mapped_column(String(20))
    pid: Mapped[int]
    ready: Mapped[bool]
    detail: Mapped[str] = mapped_column(Text)
    """What it is doing, or what it waits for."""
    heard_at: Mapped[datetime] = mapped_column(Moment)


def report(session: Session, worker: WorkerRow) -> None:
    """Note that a worker is alive."""
    worker.heard_at = now()
    session.merge(worker)


def gone(session: Session, worker_ids: Collection[str]) -> None:
    """Note that workers have ended."""
    session.execute(delete(WorkerRow).where(WorkerRow.id.in_(worker_ids)))


def listed(session: Session) -> list[str]:
    """The ids of the workers that have not ended in good order."""
    return list(session.scalars(select(WorkerRow.id)))


def alive(session: Session) -> list[WorkerRow]:
    """The workers heard of lately."""
    query = select(WorkerRow).where(WorkerRow.heard_at > now() - STALE).order_by(WorkerRow.id)
    return list(session.scalars(query))


def waits_for(session: Session, queues: Collection[str]) -> list[str]:
    """What stands between now and each queue having a worker that can work; best nothing."""
    found = alive(session)
    ready = {worker.queue for worker in found if worker.ready}
    waiting = [f"a {queue} worker" for queue in queues if queue not in {w.queue for w in found}]
    return waiting + [
        f"{worker.id}: {worker.detail}"
        for worker in found
        if not worker.ready and worker.queue not in ready
    ]
