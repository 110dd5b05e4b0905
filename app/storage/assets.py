"""Assets: the meshes that clients brought, by their content."""

from collections.abc import Callable
from datetime import datetime
from typing import Any

from sqlalchemy import JSON, ColumnElement, LargeBinary, String, cast, exists, or_, select
from sqlalchemy.orm import InstrumentedAttribute, Mapped, Session, mapped_column

from app.domain.asset import ASSET, Asset
from app.domain.errors import Conflict, NotThere
from app.storage.base import Base, Moment, insert_once, now
from app.storage.database import Database
from app.storage.executions import ExecutionRow
from app.storage.plans import PlanRow
from app.storage.scenes import SceneRow


class AssetRow(Base):
    """A mesh, ready to be built; its id is a digest of all that makes it up."""

    __tablename__ = "assets"

    serial: Mapped[int] = mapped_column(primary_key=True)
    """Order of arrival; what lists are sorted by."""
    id: Mapped[str] = mapped_column(String(32), unique=True)
    created_at: Mapped[datetime] = mapped_column(Moment)
    name: Mapped[str] = mapped_column(String(100))
    category: Mapped[str] = mapped_column(String(100))
    colour: Mapped[str] = mapped_column(String(100))
    density: Mapped[float]
    """[kg/m³]"""
    size: Mapped[list[float]] = mapped_column(JSON)
    """Length, width, height of the bounding box [m]."""
    mass: Mapped[float]
    """[kg]"""
    faces: Mapped[int]
    parts: Mapped[int]
    """Convex ones that collide."""
    file_bytes: Mapped[int]
    """Of the file that was sent."""
    shape: Mapped[bytes] = mapped_column(LargeBinary, deferred=True)

    def to_domain(self) -> Asset:
        """The asset."""
        length, width, height = self.size
        return Asset(
            id=self.id,
            name=self.name,
            category=self.category,
            colour=self.colour,
            density=self.density,
            size=(length, width, height),
            shape=self.shape,
        )


def find(session: Session, asset_id: str) -> AssetRow | None:
    """The asset of this id, or None."""
    return session.scalar(select(AssetRow).where(AssetRow.id == asset_id))


def get(session: Session, asset_id: str) -> AssetRow:
    """One asset.

    Raises:
        NotThere: no asset has this id.
    """
    row = find(session, asset_id)
    if row is None:
        raise NotThere("asset", asset_id)
    return row


def add(session: Session, asset: Asset, *, mass: float, counts: dict[str, int]) -> AssetRow:
    """Keep an asset; ``counts`` are its ``faces``, ``parts`` and ``file_bytes``.

    Somebody may send the same one at the same time; both get the one that was first.
    """
    query = insert_once(session, AssetRow).values(
        id=asset.id,
        created_at=now(),
        name=asset.name,
        category=asset.category,
        colour=asset.colour,
        density=asset.density,
        size=list(asset.size),
        mass=mass,
        shape=asset.shape,
        **counts,
    )
    session.execute(query)
    return get(session, asset.id)


def page(session: Session, *, before: int | None, limit: int) -> list[AssetRow]:
    """The newest assets that came before ``before``."""
    query = select(AssetRow).order_by(AssetRow.serial.desc()).limit(limit)
    if before is not None:
        query = query.where(AssetRow.serial < before)
    return list(session.scalars(query))


def remove(session: Session, asset_id: str) -> None:
    """Forget an asset.

    Raises:
        NotThere: no asset has this id.
        Conflict: a stored scene, plan or execution names it and could no longer be shown.
    """
    row = get(session, asset_id)
    kind = f"{ASSET}{asset_id}"
    for noun, named in (
        ("scene", _names(SceneRow.scene, kind)),
        ("plan", or_(_names(PlanRow.given_scene, kind), _names(PlanRow.scene, kind))),
        ("execution", _names(ExecutionRow.scene, kind)),
    ):
        if session.scalar(select(exists().where(named))):
            raise Conflict(f"a stored {noun} has {kind!r} in it; the asset is kept with it")
    session.delete(row)


def lookup(database: Database) -> Callable[[str], Asset | None]:
    """How a world finds an asset by its id."""

    def find_asset(asset_id: str) -> Asset | None:
        with database.reading() as session:
            row = find(session, asset_id)
            return None if row is None else row.to_domain()

    return find_asset


def _names(column: InstrumentedAttribute[dict[str, Any]], kind: str) -> ColumnElement[bool]:
    return cast(column, String).contains(kind, autoescape=True)
