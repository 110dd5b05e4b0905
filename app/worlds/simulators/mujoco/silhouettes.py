"""Silhouettes: where in an image objects can be, by the boxes around them.

A ray that passes all of these boxes shows the table, the arm or nothing. No pixel of that is kept,
so casting it would change nothing but the time that an image takes.
"""

from collections.abc import Iterable
from itertools import product

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.camera import Camera

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

NEAREST = 0.02
"""A box that comes so close to a camera's plane may cover all of its image [m]."""
CORNERS = np.array(list(product((-1.0, 1.0), repeat=3)))


class Silhouettes:
    """The geoms of a model that are looked for."""

    def __init__(
        self, model: mujoco.MjModel, bodies: Iterable[int], groups: NDArray[np.uint8]
    ) -> None:
        """Find them.

        Args:
            model: with all that there is.
            bodies: ids of those whose geoms are looked for.
            groups: which geometry groups are seen at all, shape (6,).
        """
        wanted = np.isin(model.geom_bodyid, list(bodies)) & (groups[model.geom_group] > 0)
        self._geoms = np.flatnonzero(wanted)
        boxes = model.geom_aabb[self._geoms]  # (n, 6)
        self._corners = boxes[:, None, :3] + CORNERS * boxes[:, None, 3:]  # (n, 8, 3)

    def corners(self, data: mujoco.MjData) -> Array:
        """Of each geom's box as it stands now, base frame, shape (n, 8, 3) [m]."""
        turned = self._corners @ data.geom_xmat[self._geoms].reshape(-1, 3, 3).transpose(0, 2, 1)
        return turned + data.geom_xpos[self._geoms, None]


def pixels_of(corners: Array, camera: Camera, size: tuple[int, int]) -> Mask:
    """The pixels of an image, (height, width), that are in the outline of one of the boxes.

    Args:
        corners: of each box, base frame, shape (n, 8, 3) [m].
        camera: that looks.
        size: width and height of the image.
    """
    width, height = size
    mask = np.zeros((height, width), bool)
    local = (corners - camera.position) @ camera.axes().T
    if (local[..., 2] < NEAREST).any():
        mask[:] = True
        return mask
    a, b = camera.tangents(width, height)
    flat = local[..., :2] / local[..., 2:]
    places = (flat - (a[0], b[0])) / (a[1] - a[0], b[1] - b[0])  # column, row
    low = np.ceil(places.min(axis=1)).astype(int).clip(0)
    high = np.floor(places.max(axis=1)).astype(int).clip(-1) + 1
    for (left, top), (right, bottom) in zip(low.tolist(), high.tolist(), strict=True):
        mask[top:bottom, left:right] = True
    return mask
