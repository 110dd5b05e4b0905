"""Events: what happened, in order; each is written once and never changed."""

from collections.abc import Collection, Sequence
from datetime import datetime
from typing import Any

from pydantic import TypeAdapter
from sqlalchemy import JSON, String, UniqueConstraint, func, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.domain.trace import Event, ExecutionEvent
from app.storage.base import Base, Moment, insert_once, now

_events: TypeAdapter[Event] = TypeAdapter(Event)


class EventRow(Base):
    """One event of a plan or of an execution."""

    __tablename__ = "events"
    __table_args__ = (UniqueConstraint("owner", "sequence"),)

    serial: Mapped[int] = mapped_column(primary_key=True)
    owner: Mapped[str] = mapped_column(String(32))
    """Id of the plan or the execution."""
    sequence: Mapped[int]
    """0, 1, 2 … for each owner; a repeated run writes the same numbers again."""
    at: Mapped[datetime] = mapped_column(Moment)
    kind: Mapped[str] = mapped_column(String(32))
    body: Mapped[dict[str, Any]] = mapped_column(JSON)

    @property
    def event(self) -> Event:
        """The event itself."""
        return _events.validate_python(self.body)


def append(session: Session, owner: str, first: int, events: Sequence[Event]) -> None:
    """Write events under the numbers ``first``, ``first + 1`` …; those already there stay."""
    if not events:
        return
    rows = [
        {
            "owner": owner,
            "sequence": first + offset,
            "at": now(),
            "kind": event.kind,
            "body": _events.dump_python(event, mode="json"),
        }
        for offset, event in enumerate(events)
    ]
    session.execute(insert_once(session, EventRow), rows)


def after(session: Session, owner: str, sequence: int, *, limit: int = 1000) -> list[EventRow]:
    """The owner's events with a higher number, in order."""
    query = (
        select(EventRow)
        .where(EventRow.owner == owner, EventRow.sequence > sequence)
        .order_by(EventRow.sequence)
        .limit(limit)
    )
    return list(session.scalars(query))


def all_of(session: Session, owner: str) -> list[Event]:
    """All events of the owner, in order."""
    query = select(EventRow).where(EventRow.owner == owner).order_by(EventRow.sequence)
    return [row.event for row in session.scalars(query)]


def of_kinds(
    session: Session, owners: Collection[str], kinds: Collection[str]
) -> dict[str, list[Event]]:
    """The events of these kinds, by owner, in order; of a rollout most are of others."""
    query = (
        select(EventRow)
        .where(EventRow.owner.in_(owners), EventRow.kind.in_(kinds))
        .order_by(EventRow.owner, EventRow.sequence)
    )
    found: dict[str, list[Event]] = {owner: [] for owner in owners}
    for row in session.scalars(query):
        found[row.owner].append(row.event)
    return found


def of_execution(session: Session, execution_id: str) -> list[ExecutionEvent]:
    """All events of an execution, in order."""
    return [event for event in all_of(session, execution_id) if isinstance(event, ExecutionEvent)]


def same(session: Session, owner: str, other: str) -> bool:
    """Whether the same things happened to both, at the same simulated times."""
    return all_of(session, owner) == all_of(session, other)


def newest(session: Session) -> int:
    """A number that grows whenever an event is written, whoever owns it."""
    return session.scalar(select(func.max(EventRow.serial))) or 0
