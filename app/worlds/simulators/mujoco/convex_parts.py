"""ConvexParts: a mesh taken apart into convex pieces that physics can collide.

CoACD does it; it ends the whole process on some meshes, so this belongs into a process of its own.
"""

import coacd
import numpy as np
import trimesh

from app.domain.errors import AssetRefused, Fault
from app.worlds.simulators.mujoco.shapes import Points

CONVEX = 0.97
"""A mesh that fills so much of its hull is taken as convex."""
CONCAVITY = 0.06
"""What a part may differ from the mesh, relative to its size."""
MAX_PARTS, MAX_CORNERS = 24, 48
SMALLEST = 1e-9
"""A part with less volume [m³] counts for nothing."""


def hull_of(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """Its convex hull.

    Raises:
        AssetRefused: it is flat.
    """
    try:
        hull = mesh.convex_hull
    except Exception as error:
        raise _flat() from error
    if hull.volume < SMALLEST:
        raise _flat()
    return hull


def convex_parts(mesh: trimesh.Trimesh) -> tuple[Points, ...]:
    """The corners of its convex parts, each of shape (n, 3) [m].

    Raises:
        AssetRefused: it cannot be taken apart.
    """
    hull = hull_of(mesh)
    if mesh.is_watertight and mesh.volume >= CONVEX * hull.volume:
        return (np.asarray(hull.vertices),)
    coacd.set_log_level("error")
    found = coacd.run_coacd(
        coacd.Mesh(np.asarray(mesh.vertices), np.asarray(mesh.faces, np.int32)),
        threshold=CONCAVITY,
        max_convex_hull=MAX_PARTS,
        decimate=True,
        max_ch_vertex=MAX_CORNERS,
        mcts_nodes=10,
        mcts_iterations=60,
        preprocess_resolution=40,
    )
    low, high = mesh.bounds  # (3,) each; remeshing inside CoACD swells the parts a little
    clipped = [trimesh.convex.convex_hull(np.clip(corners, low, high)) for corners, _ in found]
    kept = tuple(np.asarray(part.vertices) for part in clipped if part.volume > SMALLEST)
    if not kept:
        message = "finds no part with a volume; send decomposition=hull"
        raise AssetRefused(Fault(field="decomposition", message=message))
    return kept


def _flat() -> AssetRefused:
    return AssetRefused(Fault(field="body", message="is flat; a solid with a volume is wanted"))
