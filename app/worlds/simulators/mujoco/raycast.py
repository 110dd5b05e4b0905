"""Ray casting: what the pixels of a camera meet, without a display."""

from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.camera import Camera

Array = NDArray[np.float64]
Ints = NDArray[np.int_]

FARTHEST = 5.0
"""Nothing beyond this distance is seen [m]."""


class Met(NamedTuple):
    """What n rays hit."""

    geoms: NDArray[np.int32]
    """(n,); -1 where nothing was hit."""
    depths: Array
    """Along the camera's axis (n,) [m]."""
    points: Array
    """Base frame, shape (n, 3) [m]."""
    normals: Array
    """Facing the camera, base frame, shape (n, 3)."""


def cast(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    camera: Camera,
    size: tuple[int, int],
    pixels: tuple[Ints, Ints],
    groups: NDArray[np.uint8],
) -> Met:
    """Cast some of an image's pixels.

    Args:
        model: what stands there.
        data: how it stands.
        camera: that looks.
        size: width and height of the image.
        pixels: rows (n,) and columns (n,).
        groups: which geometry groups are seen, shape (6,).
    """
    rows, columns = pixels
    count = len(rows)
    a, b = camera.tangents(*size)
    rays = np.stack([a[columns], b[rows], np.ones(count)], axis=1) @ camera.axes()
    lengths = np.sqrt((rays**2).sum(axis=1))
    rays /= lengths[:, None]
    geoms, distances = np.zeros(count, np.int32), np.zeros(count)
    normals = np.zeros(3 * count)
    position = np.array(camera.position)
    mujoco.mj_multiRay(
        model, data, position, rays.reshape(-1), groups, True,
        -1, geoms, distances, normals, count, FARTHEST,
    )  # fmt: skip
    normals = normals.reshape(-1, 3)
    # A hollow body is seen from inside as well: a normal always faces the camera.
    normals *= -np.sign((normals * rays).sum(axis=1, keepdims=True))
    depths = np.where(geoms >= 0, distances / lengths, 0.0)
    return Met(geoms, depths, position + rays * distances[:, None], normals)
