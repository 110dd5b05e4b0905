"""Assets: clients' own meshes and MJCF bodies, for scenes to name by `"kind": "asset:<id>"`."""

import hashlib
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Depends, Query, Request, Response
from starlette.exceptions import HTTPException

from app.api.paging import Cursor, Limit, part, position
from app.api.parts import Using
from app.api.schemas.assets import AssetShown
from app.api.schemas.base import Page, Text
from app.domain.asset import ASSET, Asset
from app.domain.errors import AssetRefused, Fault
from app.storage import assets
from app.storage.assets import AssetRow
from app.worlds.simulators.mujoco.colours import parse_colour
from app.worlds.simulators.mujoco.kind import GRIPPER
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.upload import Format, Upload, digest

router = APIRouter(prefix="/assets", tags=["assets"])

FORMATS: dict[str, Format] = {
    "model/obj": "obj",
    "model/stl": "stl",
    "model/gltf-binary": "glb",
    "application/xml": "xml",
    "application/zip": "zip",
}
Word = Annotated[Text, Query(min_length=1, max_length=100)]
BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "description": "The file: OBJ, STL, GLB, an MJCF body of up to 64 geoms, or a zip of one with "
        "its meshes; at most 20 MB and 200,000 faces.",
        "content": {name: {"schema": {"type": "string", "format": "binary"}} for name in FORMATS},
    }
}


def _format(request: Request) -> Format:
    """Told by the media type."""
    given = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if given not in FORMATS:
        raise HTTPException(
            415, f"send a mesh, MJCF or a zip with Content-Type: {', '.join(FORMATS)}"
        )
    return FORMATS[given]


async def _body(request: Request) -> bytes:
    return await request.body()


class Described:
    """What a client says of its thing, in the query."""

    def __init__(
        self,
        name: Annotated[Word, Query(description="What people call it, singular.")] = "thing",
        category: Annotated[Word | None, Query(description="Default: its name.")] = None,
        colour: Annotated[Word, Query(description="CSS name or `#rrggbb`.")] = "#9aa5b1",
        density: Annotated[
            float,
            Query(ge=20, le=20_000, description="Of the solid [kg/m³]; MJCF says its own."),
        ] = 600.0,
    ) -> None:
        self.name, self.category, self.colour = name, category or name, colour
        self.density = density


class Measured:
    """How the file is to be read, in the query."""

    def __init__(
        self,
        form: Annotated[Format, Depends(_format)],
        scale: Annotated[
            float, Query(ge=1e-6, le=1e3, description="Metres per unit of the file.")
        ] = 1.0,
        up: Annotated[
            Literal["x", "y", "z"] | None,
            Query(description="The file's axis that points up; default y in GLB, else z."),
        ] = None,
        decomposition: Annotated[
            Literal["parts", "hull"],
            Query(description="Collide as convex parts, or as the convex hull."),
        ] = "parts",
    ) -> None:
        self.upload = Upload(
            format=form,
            scale=scale,
            up=up or ("y" if form == "glb" else "z"),
            decomposition=decomposition,
        )


@router.post("", status_code=201, openapi_extra=BODY)
def create_asset(
    parts: Using,
    response: Response,
    data: Annotated[bytes, Depends(_body)],
    said: Annotated[Described, Depends()],
    measured: Annotated[Measured, Depends()],
) -> AssetShown:
    """Take a mesh or an MJCF body in; the same one with the same words is the same asset."""
    if parse_colour(said.colour) is None:
        message = f"{said.colour[:40]!r} is no colour; give a CSS name like 'red', or '#d62828'"
        raise AssetRefused(Fault(field="colour", message=message))
    asset_id = _digest(data, said, measured.upload)
    response.headers["Location"] = f"/assets/{asset_id}"
    with parts.database.reading() as session:
        if known := assets.find(session, asset_id):
            response.status_code = 200
            return _shown(known)
    made = digest(data, measured.upload)
    density = said.density if made.density is None else made.density
    asset = Asset(
        id=asset_id,
        name=said.name,
        category=said.category,
        colour=said.colour,
        density=density,
        size=made.size,
        shape=made.shape,
    )
    counts = {"faces": made.faces, "parts": made.parts, "file_bytes": len(data)}
    with parts.database.transaction() as session:
        return _shown(assets.add(session, asset, mass=density * made.volume, counts=counts))


@router.get("", response_model=Page)
def list_assets(parts: Using, limit: Limit = 20, cursor: Cursor = None) -> Response:
    """Assets, newest first."""
    with parts.database.reading() as session:
        rows = assets.page(session, before=position(cursor), limit=limit + 1)
    return part(rows, limit, _shown)


@router.get("/{asset_id}")
def read_asset(asset_id: str, parts: Using) -> AssetShown:
    """One asset."""
    with parts.database.reading() as session:
        return _shown(assets.get(session, asset_id))


@router.delete("/{asset_id}", status_code=204)
def delete_asset(asset_id: str, parts: Using) -> None:
    """Forget an asset; one that a stored scene, plan or execution has in it stays."""
    with parts.database.transaction() as session:
        assets.remove(session, asset_id)
    kinds.assets.forget(asset_id)


def _digest(data: bytes, said: Described, upload: Upload) -> str:
    told = repr((said.name, said.category, said.colour, said.density, upload))
    return f"as_{hashlib.sha256(told.encode() + data).hexdigest()[:24]}"


def _shown(row: AssetRow) -> AssetShown:
    names = ("id", "created_at", "name", "category", "colour", "size", "density")
    told = {name: getattr(row, name) for name in (*names, "mass", "faces", "parts", "file_bytes")}
    narrow = min(row.size[:2]) <= GRIPPER
    return AssetShown.model_validate({**told, "kind": f"{ASSET}{row.id}", "graspable": narrow})
