"""Depth: what a depth camera measures, and the surfaces that are found in its noise.

The inverse depth of a plane is linear in the pixel's tangents (a, b): 1/Z = q + g_a a + g_b b, so a
plane fitted by least squares to a pixel's neighbourhood gives both a quieter depth and the normal.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Ints = NDArray[np.int_]

JUMP = 0.012
"""Neighbours deeper or nearer by more than this are another surface [m]."""
DROPOUT = 0.5
"""The share of pixels that measure nothing where two surfaces meet."""
FEWEST = 4
"""So many pixels of one surface must lie together for a plane to be fitted."""
_STEADY = 1e-9
"""Added to the normal equations' diagonal: a row of pixels in one line has no unique plane."""


@dataclass(frozen=True, slots=True)
class DepthImage:
    """A labelled depth image; a pixel without a measurement has label -1."""

    labels: NDArray[np.int32]
    """What is seen, shape (height, width); 0 and up: an object's number; -2: something else."""
    depths: Array
    """Distance along the camera's axis, shape (height, width) [m]."""
    tangents: tuple[Array, Array]
    """Of the columns (width,) and of the rows (height,)."""

    def with_noise(self, deviation: float, rng: np.random.Generator) -> "DepthImage":
        """As a real camera measures it: noise everywhere, and nothing at many of the edges.

        Args:
            deviation: standard deviation of the distance along a pixel's ray [m].
            rng: where the noise comes from.
        """
        labels, depths = self.labels.copy(), self.depths.copy()
        rows, columns = np.nonzero(labels != _NOTHING)
        a, b = self.tangents
        stretch = np.sqrt(1 + a[columns] ** 2 + b[rows] ** 2)
        depths[rows, columns] += rng.normal(0.0, deviation, len(rows)) / stretch
        dropped = _edges(self.labels, self.depths)[rows, columns] & (
            rng.random(len(rows)) < DROPOUT
        )
        labels[rows[dropped], columns[dropped]] = _NOTHING
        return DepthImage(labels, depths, self.tangents)

    def surfaces(self, radius: int) -> tuple[NDArray[np.int32], Array, Array]:
        """Planes through the neighbourhood of every pixel that shows an object.

        Args:
            radius: the neighbourhood reaches so many pixels to each side.

        Returns:
            Labels (n,), points (n, 3) and normals (n, 3), both in the camera's axes; the normals
            face the camera.
        """
        height, width = self.labels.shape
        padded = (height + 2 * radius, width + 2 * radius)
        labels = np.full(padded, _NOTHING, np.int32)
        inverse = np.zeros(padded)
        inside = np.s_[radius : radius + height, radius : radius + width]
        labels[inside] = self.labels
        inverse[inside] = 1.0 / np.where(self.depths > 0, self.depths, 1.0)
        rows, columns = np.nonzero(self.labels >= 0)
        at = (rows + radius) * padded[1] + columns + radius
        offsets = np.arange(-radius, radius + 1)
        down, across = (grid.ravel() for grid in np.meshgrid(offsets, offsets, indexing="ij"))
        around = at[:, None] + down * padded[1] + across  # (n, k)
        labels, inverse = labels.ravel(), inverse.ravel()
        centre = inverse[at]
        same = labels[around] == labels[at][:, None]
        same &= np.abs(inverse[around] - centre[:, None]) < JUMP * centre[:, None] ** 2
        enough = same.sum(axis=1) >= FEWEST
        around, same, at = around[enough], same[enough], at[enough]
        a, b = self.tangents
        fitted = _planes(inverse[around], same, down * (b[1] - b[0]), across * (a[1] - a[0]))
        a, b = a[columns[enough]], b[rows[enough]]
        q, slope_b, slope_a = fitted.T
        depth = 1.0 / q
        points = np.stack([a * depth, b * depth, depth], axis=1)
        normals = -np.stack([slope_a, slope_b, q - slope_a * a - slope_b * b], axis=1)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        return labels[at], points, normals


_NOTHING = -1


def _edges(labels: NDArray[np.int32], depths: Array) -> NDArray[np.bool_]:
    """Where the neighbour to one side shows something else, or the same much deeper."""
    edges = np.zeros(labels.shape, bool)
    for axis in (0, 1):
        ahead = np.moveaxis(edges, axis, 0)
        along, deep = np.moveaxis(labels, axis, 0), np.moveaxis(depths, axis, 0)
        differs = (along[1:] != along[:-1]) | (np.abs(deep[1:] - deep[:-1]) > 2 * JUMP)
        ahead[1:] |= differs
        ahead[:-1] |= differs
    return edges


def _planes(inverse: Array, same: NDArray[np.bool_], down: Array, across: Array) -> Array:
    """Least squares of inverse depths (n, k) over offsets (k,), where ``same``: shape (n, 3)."""
    weights = same.astype(float)
    basis = np.stack([np.ones_like(down), down, across])  # (3, k)
    scale = np.array([1.0, np.abs(down).max(), np.abs(across).max()])
    basis = basis / scale[:, None]
    products = (basis[:, None] * basis[None]).reshape(9, -1)  # (9, k)
    normal = (weights @ products.T).reshape(-1, 3, 3) + _STEADY * np.eye(3)
    right = (weights * inverse) @ basis.T  # (n, 3)
    return np.linalg.solve(normal, right[..., None])[..., 0] / scale
