"""UploadedMesh: a stranger's file read as triangles, in metres, standing on z = 0.

Only the bytes given are read: materials, textures and whatever a file refers to outside itself are
refused or passed over, and nothing in it is carried out.
"""

import io
import json
import struct
from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
import trimesh

from app.domain.errors import AssetRefused, Fault
from app.worlds.simulators.mujoco.shapes import Points
from app.worlds.simulators.mujoco.upload import Format, Upload

MAX_FACES = 200_000
MAX_NODES = 10_000
SIDES = (0.005, 0.60)
"""How short and how long a side of the bounding box may be [m]."""
_GLB_MAGIC, _JSON_CHUNK = 0x46546C67, 0x4E4F534A
_UNITS = {0.001: "millimetres", 0.01: "centimetres", 0.0254: "inches"}


def read_mesh(data: bytes, upload: Upload) -> trimesh.Trimesh:
    """The mesh, in metres, z up, the middle of its footprint at the origin, standing on z = 0.

    Raises:
        AssetRefused: it is no such mesh, has too many faces or not the size of a thing on a table.
    """
    mesh = _turned(_parsed(data, upload.format), upload.up)
    low, high = mesh.bounds  # (3,) each
    if fault := size_fault((high - low) * upload.scale, upload.scale):
        raise AssetRefused(fault)
    middle = (low + high) / 2
    vertices = (mesh.vertices - (middle[0], middle[1], low[2])) * upload.scale
    return trimesh.Trimesh(np.asarray(vertices), mesh.faces, process=False)


def _parsed(data: bytes, form: Format) -> trimesh.Trimesh:
    if form == "glb":
        _check_glb(data)
    try:
        # Without a resolver nothing outside the bytes is found; materials are passed over.
        plain: dict[str, Any] = {} if form == "stl" else {"skip_materials": True}
        scene = trimesh.load_scene(io.BytesIO(data), file_type=form, **plain)
    except MemoryError:
        raise
    except Exception as error:
        raise _refused(
            f"cannot be read as {form.upper()}: {error or type(error).__name__}"
        ) from error
    drawn = [scene.geometry[scene.graph[node][1]] for node in scene.graph.nodes_geometry]
    faces = sum(len(each.faces) for each in drawn if isinstance(each, trimesh.Trimesh))
    if not faces:
        raise _refused(f"has no triangles that can be read as {form.upper()}")
    if faces > MAX_FACES:
        raise _refused(f"has {faces:,} faces; at most {MAX_FACES:,} are taken")
    mesh = scene.to_mesh()
    if not np.isfinite(mesh.vertices).all():
        raise _refused("has corners that are no numbers")
    mesh.update_faces(mesh.nondegenerate_faces())
    mesh.remove_unreferenced_vertices()
    mesh.merge_vertices()
    if not len(mesh.faces):
        raise _refused("has no triangle with an area")
    return mesh


def _turned(mesh: trimesh.Trimesh, up: Literal["x", "y", "z"]) -> trimesh.Trimesh:
    """The same with z up; a right-handed frame stays one."""
    order = {"x": [1, 2, 0], "y": [2, 0, 1], "z": [0, 1, 2]}[up]
    return trimesh.Trimesh(np.asarray(mesh.vertices)[:, order], mesh.faces, process=False)


def size_fault(size: Points, scale: float) -> Fault | None:
    """What is wrong with the sides of a bounding box, shape (3,) [m]."""
    low, high = SIDES
    if all(low <= side <= high for side in size):
        return None
    shown = " x ".join(f"{side:.4g}" for side in size)
    message = f"makes it {shown} m; every side is to be from {low} to {high} m"
    for unit, name in _UNITS.items():
        if unit != scale and all(low <= side / scale * unit <= high for side in size):
            message += f"; if the file is in {name}, give scale={unit}"
            break
    return Fault(field="scale", message=message)


def _check_glb(data: bytes) -> None:
    """Refuse what is no GLB, refers to other files, is packed, or claims more than it has."""
    tree = _glb_tree(data)
    refers = [
        kind for kind in ("buffers", "images") for each in _entries(tree, kind) if "uri" in each
    ]
    if refers:
        raise _refused(f"refers to {refers[0]} outside itself; put everything into the one file")
    if tree.get("extensionsRequired"):
        wanted = ", ".join(map(str, tree["extensionsRequired"]))[:200]
        raise _refused(f"needs extensions that are not known here: {wanted}; export without them")
    if len(_entries(tree, "nodes")) > MAX_NODES:
        raise _refused(f"has more than {MAX_NODES:,} nodes")
    counts = [each.get("count", 0) for each in _entries(tree, "accessors")]
    wrong = [count for count in counts if not isinstance(count, int) or count < 0]
    if wrong or sum(counts) > 10 * len(data):
        raise _refused("claims arrays that are larger than the file")


def _glb_tree(data: bytes) -> Mapping[str, Any]:
    try:
        magic, version, _, length, chunk = struct.unpack_from("<5I", data)
        if (magic, version, chunk) != (_GLB_MAGIC, 2, _JSON_CHUNK) or length > len(data) - 20:
            raise _refused("is no GLB of version 2")
        tree = json.loads(data[20 : 20 + length])
    except (struct.error, ValueError, RecursionError) as error:
        raise _refused("is no GLB of version 2") from error
    if not isinstance(tree, dict):
        raise _refused("is no GLB of version 2")
    return tree


def _entries(tree: Mapping[str, Any], kind: str) -> list[dict[str, Any]]:
    found = tree.get(kind, [])
    if not isinstance(found, list) or not all(isinstance(each, dict) for each in found):
        raise _refused(f"has {kind} that are no list of objects")
    return found


def _refused(message: str) -> AssetRefused:
    return AssetRefused(Fault(field="body", message=message))
