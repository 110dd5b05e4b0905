"""Scenes: kept for later plans, and checked without planning anything."""

from fastapi import APIRouter, Response

from app.api.paging import Cursor, Limit, part, position
from app.api.parts import Using
from app.api.schemas.base import Page, Seed
from app.api.schemas.scenes import SceneGiven, SceneStored, SceneValidated
from app.api.submission import complete_scene
from app.domain.errors import Fault, Refused
from app.storage import scenes
from app.storage.documents import scene_document
from app.storage.scenes import SceneRow

router = APIRouter(prefix="/scenes", tags=["scenes"])


@router.post("", status_code=201)
def create_scene(given: SceneGiven, response: Response, parts: Using) -> SceneStored:
    """Keep a scene; plans name it by `scene_id`."""
    _completed(given, 0)
    with parts.database.transaction() as session:
        row = scenes.add(session, scene_document(given.to_domain()))
    response.headers["Location"] = f"/scenes/{row.id}"
    return _shown(row)


@router.post("/validate")
def validate_scene(given: SceneGiven, seed: Seed = 0) -> SceneValidated:
    """Check a scene, and see how its world fills in what it leaves open."""
    return SceneValidated.model_validate({"valid": True, "scene": _completed(given, seed)})


@router.get("", response_model=Page)
def list_scenes(parts: Using, limit: Limit = 20, cursor: Cursor = None) -> Response:
    """Scenes, newest first."""
    with parts.database.reading() as session:
        rows = scenes.page(session, before=position(cursor), limit=limit + 1)
    return part(rows, limit, _shown)


@router.get("/{scene_id}")
def read_scene(scene_id: str, parts: Using) -> SceneStored:
    """One scene, as its client described it."""
    with parts.database.reading() as session:
        return _shown(scenes.get(session, scene_id))


@router.put("/{scene_id}")
def replace_scene(scene_id: str, given: SceneGiven, parts: Using) -> SceneStored:
    """Describe a scene anew; plans already made for it keep the old one."""
    _completed(given, 0)
    with parts.database.transaction() as session:
        row = scenes.get(session, scene_id)
        row.scene = scene_document(given.to_domain())
        return _shown(row)


@router.delete("/{scene_id}", status_code=204)
def delete_scene(scene_id: str, parts: Using) -> None:
    """Forget a scene; plans made for it keep their own copy."""
    with parts.database.transaction() as session:
        scenes.remove(session, scene_id)


def _completed(given: SceneGiven, seed: int) -> dict[str, object]:
    """The completed scene; the faults' fields start at the scene, which is the whole body here."""
    try:
        return scene_document(complete_scene(given.to_domain(), seed))
    except Refused as refused:
        refused.faults = tuple(
            Fault(field=fault.field.removeprefix("scene."), message=fault.message)
            for fault in refused.faults
        )
        raise


def _shown(row: SceneRow) -> SceneStored:
    return SceneStored.model_validate({"id": row.id, "created_at": row.created_at, **row.scene})
