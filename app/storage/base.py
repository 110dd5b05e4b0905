"""Base: what all tables share."""

import secrets
from datetime import UTC, datetime
from typing import TypeVar

from sqlalchemy import DateTime, Dialect, MetaData, Select
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import DeclarativeBase, Session
from sqlalchemy.types import TypeDecorator

Entity = TypeVar("Entity")


class Base(DeclarativeBase):
    """Every table's base; constraints get names, so that migrations can speak of them."""

    metadata = MetaData(
        naming_convention={
            "ix": "ix_%(column_0_label)s",
            "uq": "uq_%(table_name)s_%(column_0_name)s",
            "fk": "fk_%(table_name)s_%(column_0_name)s",
            "pk": "pk_%(table_name)s",
        }
    )


class Moment(TypeDecorator[datetime]):
    """A time in UTC; SQLite would forget the zone."""

    impl = DateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        """As it is written."""
        del dialect  # Unused.
        return None if value is None else value.astimezone(UTC)

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        """As it is read."""
        del dialect  # Unused.
        return None if value is None else value.replace(tzinfo=value.tzinfo or UTC)


def insert_once(session: Session, table: type[Base]) -> postgresql.Insert | sqlite.Insert:
    """Inserts rows; those that are there already stay as they are."""
    dialect = postgresql if session.get_bind().dialect.name == "postgresql" else sqlite
    return dialect.insert(table).on_conflict_do_nothing()


def locked(query: Select[Entity]) -> Select[Entity]:
    """The query, whose rows nobody else changes until the transaction ends.

    Others may go on writing rows that refer to them, since their keys never change. They are read
    anew: somebody may have changed them while the lock was waited for.
    """
    return query.with_for_update(key_share=True).execution_options(populate_existing=True)


def now() -> datetime:
    """The time, in UTC."""
    return datetime.now(UTC)


def new_id(prefix: str) -> str:
    """A fresh opaque id: ``pl_…`` with 64 random bits."""
    return f"{prefix}_{secrets.token_hex(8)}"
