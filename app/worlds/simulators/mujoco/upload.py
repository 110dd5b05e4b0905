"""Upload: what a client says of a mesh or a body, and what becomes of it in quarantine."""

import json
import os
import subprocess
import sys
import threading
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Literal

from app.domain.errors import AssetRefused, Busy, Fault

Format = Literal["obj", "stl", "glb", "xml", "zip"]
"""Of the last two, the XML is MJCF: alone, or in the zip with its meshes."""
ROOT = Path(__file__).parents[4]
QUARANTINE = "app.worlds.simulators.mujoco.quarantine"
PROCESSOR, PATIENCE = 60, 120.0
"""Seconds of processor time, and of waiting, after which a mesh is given up."""
AT_ONCE = threading.BoundedSemaphore(1)
"""Uploads take turns, so that no number of them takes the machine from the simulations."""
TURN = 2.0
"""How long one waits for its turn [s]; who waits holds a thread that others' requests need."""
RETRY_AFTER = 20
"""What a mesh takes, roughly [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Upload:
    """What a client says of its file."""

    format: Format
    scale: float = 1.0
    """Metres per unit of the file."""
    up: Literal["x", "y", "z"] = "z"
    """The axis of the file that points up."""
    decomposition: Literal["parts", "hull"] = "parts"
    """Collide as several convex parts, or as the one convex hull."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Digested:
    """What became of it."""

    size: tuple[float, float, float]
    """Length, width, height of the bounding box [m]."""
    faces: int
    parts: int
    volume: float
    """Of what collides [m³]."""
    density: float | None
    """What the file says of it, evenly spread [kg/m³]; a mesh says nothing."""
    shape: bytes
    """For ``Asset.shape``."""


def digest(data: bytes, upload: Upload) -> Digested:
    """Read and check a mesh and take it apart, in a process that may die of it.

    Raises:
        AssetRefused: it cannot be had as an object; the fault names what would help.
        Busy: others' meshes are being read.
    """
    if not AT_ONCE.acquire(timeout=TURN):
        message = "the meshes of others are being read; send this one again a little later"
        raise Busy(message, retry_after=RETRY_AFTER)
    try:
        told = _quarantined(data, upload)
    finally:
        AT_ONCE.release()
    line, _, shape = told.partition(b"\n")
    answer = json.loads(line)
    if "faults" in answer:
        raise AssetRefused(*(Fault(**fault) for fault in answer["faults"]))
    length, width, height = answer.pop("size")
    return Digested(size=(length, width, height), shape=shape, **answer)


def _quarantined(data: bytes, upload: Upload) -> bytes:
    """What the process told: a line of JSON, then the shape."""
    try:
        done = subprocess.run(
            [sys.executable, "-m", QUARANTINE],
            input=json.dumps(asdict(upload)).encode() + b"\n" + data,
            capture_output=True,
            env=_environment(),
            timeout=PATIENCE,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise _given_up(upload) from None
    if done.returncode:
        raise _given_up(upload)
    return done.stdout


def _environment() -> dict[str, str]:
    """No settings and no keys; only what finds the code, and one thread."""
    one_thread = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
    return {"PATH": os.environ.get("PATH", ""), "PYTHONPATH": str(ROOT), **one_thread}


def _given_up(upload: Upload) -> AssetRefused:
    message = f"was given up after a crash or {PROCESSOR} s of work; send a simpler mesh"
    if upload.decomposition == "hull":
        return AssetRefused(Fault(field="body", message=message))
    return AssetRefused(Fault(field="decomposition", message=f"{message}, or decomposition=hull"))
