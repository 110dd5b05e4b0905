"""Surface: points spread over the outside of a body, for working out where it would come to lie."""

import math

import mujoco
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SPACING = 0.008
"""The most that neighbouring points are apart [m]."""
_ROUND = (int(mujoco.mjtGeom.mjGEOM_SPHERE), int(mujoco.mjtGeom.mjGEOM_ELLIPSOID))


def surface_points(model: mujoco.MjModel, data: mujoco.MjData, body: int) -> Array:
    """Points on the bounding surfaces of a body's collision geoms, base frame, shape (n, 3) [m].

    Balls and ellipsoids are followed, everything else is taken for its bounding box.
    """
    start = int(model.body_geomadr[body])
    pieces = [
        data.geom_xpos[geom] + _local(model, geom) @ data.geom_xmat[geom].reshape(3, 3).T
        for geom in range(start, start + int(model.body_geomnum[body]))
        if model.geom_contype[geom]
    ]
    return np.concatenate(pieces)


def _local(model: mujoco.MjModel, geom: int) -> Array:
    middle, half = model.geom_aabb[geom][:3], model.geom_aabb[geom][3:]
    count = [max(2, math.ceil(2 * float(extent) / SPACING) + 1) for extent in half]
    axes = np.meshgrid(*(np.linspace(-1, 1, n) for n in count), indexing="ij")
    unit = np.stack(axes, axis=-1).reshape(-1, 3)
    unit = unit[np.abs(unit).max(axis=1) > 1 - 1e-9]
    if int(model.geom_type[geom]) in _ROUND:
        unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    return middle + unit * half
