"""Scenes that clients keep for later plans."""

from datetime import datetime
from typing import Any

from sqlalchemy import JSON, String, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.domain.errors import NotThere
from app.storage.base import Base, Moment, new_id, now


class SceneRow(Base):
    """A scene as its client described it."""

    __tablename__ = "scenes"

    serial: Mapped[int] = mapped_column(primary_key=True)
    """Order of arrival; what lists are sorted by."""
    id: Mapped[str] = mapped_column(String(32), unique=True)
    created_at: Mapped[datetime] = mapped_column(Moment)
    scene: Mapped[dict[str, Any]] = mapped_column(JSON)


def add(session: Session, scene: dict[str, Any]) -> SceneRow:
    """Keep a scene."""
    row = SceneRow(id=new_id("sc"), created_at=now(), scene=scene)
    session.add(row)
    session.flush()
    return row


def get(session: Session, scene_id: str) -> SceneRow:
    """One scene.

    Raises:
        NotThere: no scene has this id.
    """
    row = session.scalar(select(SceneRow).where(SceneRow.id == scene_id))
    if row is None:
        raise NotThere("scene", scene_id)
    return row


def page(session: Session, *, before: int | None, limit: int) -> list[SceneRow]:
    """The newest scenes that came before ``before``."""
    query = select(SceneRow).order_by(SceneRow.serial.desc()).limit(limit)
    if before is not None:
        query = query.where(SceneRow.serial < before)
    return list(session.scalars(query))


def remove(session: Session, scene_id: str) -> None:
    """Forget a scene; plans made for it keep their own copy.

    Raises:
        NotThere: no scene has this id.
    """
    session.delete(get(session, scene_id))
