"""Quarantine: the process in which a stranger's mesh or body becomes a shape (``python -m`` this module).

It has no settings, little memory and time, writes no file, and may die of what it reads without
harm to the service. On standard input it is told an ``Upload`` as a line of JSON and the file's
bytes; on standard output it answers with a line of JSON and the packed shape.
"""

import json
import os
import resource
import sys
from dataclasses import asdict
from typing import Any

import mujoco
import numpy as np
import trimesh

from app.domain.asset import Asset
from app.domain.errors import AssetRefused, Fault
from app.worlds.simulators.mujoco.asset_kind import AssetKind
from app.worlds.simulators.mujoco.convex_parts import convex_parts, hull_of
from app.worlds.simulators.mujoco.mjcf import read_mjcf
from app.worlds.simulators.mujoco.shapes import Mesh, Points
from app.worlds.simulators.mujoco.solid import Solid
from app.worlds.simulators.mujoco.solid_shape import Look, Shape
from app.worlds.simulators.mujoco.upload import PROCESSOR, Upload
from app.worlds.simulators.mujoco.uploaded_mesh import read_mesh

MEMORY = 4 * 2**30  # bytes of address space
_GREY = (0.5, 0.5, 0.5, 1.0)


def main() -> None:
    """Answer one upload."""
    for limit, value in (
        (resource.RLIMIT_AS, MEMORY),
        (resource.RLIMIT_CPU, PROCESSOR),
        (resource.RLIMIT_FSIZE, 0),
        (resource.RLIMIT_CORE, 0),
    ):
        resource.setrlimit(limit, (value, value))
    answer = os.dup(1)
    os.dup2(2, 1)  # What libraries print is no part of the answer.
    line, _, data = sys.stdin.buffer.read().partition(b"\n")
    told, shape = _answered(data, Upload(**json.loads(line)))
    with os.fdopen(answer, "wb") as out:
        out.write(json.dumps(told).encode() + b"\n" + shape)


def _answered(data: bytes, upload: Upload) -> tuple[dict[str, Any], bytes]:
    try:
        return _digested(data, upload)
    except AssetRefused as refused:
        return {"faults": [asdict(fault) for fault in refused.faults]}, b""
    except MemoryError:
        fault = Fault(field="body", message="takes too much memory; send a simpler mesh")
        return {"faults": [asdict(fault)]}, b""


def _digested(data: bytes, upload: Upload) -> tuple[dict[str, Any], bytes]:
    read = _body if upload.format in ("xml", "zip") else _mesh
    told, shape = read(data, upload)
    packed = shape.pack()
    _try_out(packed, told["size"])
    return told | {"parts": len(shape.parts) + len(shape.primitives)}, packed


def _mesh(data: bytes, upload: Upload) -> tuple[dict[str, Any], Shape]:
    mesh = read_mesh(data, upload)
    hull = np.asarray(hull_of(mesh).vertices)
    parts: tuple[Points, ...] = (hull,) if upload.decomposition == "hull" else convex_parts(mesh)
    length, width, height = (round(float(side), 4) for side in mesh.extents)
    told = {
        "size": (length, width, height),
        "faces": len(mesh.faces),
        "volume": sum(float(trimesh.convex.convex_hull(part).volume) for part in parts),
        "density": None,
    }
    looks = (Look(Mesh(np.asarray(mesh.vertices), np.asarray(mesh.faces))),)
    return told, Shape(looks, parts)


def _body(data: bytes, upload: Upload) -> tuple[dict[str, Any], Shape]:
    body = read_mjcf(data, upload)
    told = {
        "size": body.size,
        "faces": body.faces,
        "volume": body.volume,
        "density": body.mass / body.volume,
    }
    return told, body.shape


def _try_out(shape: bytes, size: tuple[float, float, float]) -> None:
    """Build it once, as every scene with it will.

    Raises:
        AssetRefused: MuJoCo cannot have it.
    """
    asset = Asset(id="", name="", category="", colour="grey", density=600.0, size=size, shape=shape)
    spec = mujoco.MjSpec()
    body = spec.worldbody.add_body(name="asset")
    body.add_freejoint()
    solid = Solid(spec, body, asset.density)
    AssetKind(asset).build(solid, size, _GREY)
    solid.finish()
    try:
        spec.compile()
    except ValueError as error:
        fault = Fault(field="body", message=f"cannot be built in physics: {error}")
        raise AssetRefused(fault) from error


if __name__ == "__main__":
    main()
