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
        """As a real camera measures it: noise on all objects, and nothing at many of their edges.

        Args:
            deviation: standard deviation of the distance along a pixel's ray [m].
            rng: where the noise comes from.
        """
        labels, depths = self.labels.copy(), self.depths.copy()
        rows, columns = np.nonzero(labels >= 0)
        a, b = self.tangents
        stretch = np.sqrt(1 + a[columns] ** 2 + b[rows] ** 2)
        depths[rows, columns] += rng.normal(0.0, deviation, len(rows)) / stretch
        dropped = self._edges(rows, columns) & (rng.random(len(rows)) < DROPOUT)
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
        around = at[:, None] + (down * padded[1] + across)  # (n, k)
        labels, inverse = labels.ravel(), inverse.ravel()
        centre = inverse[at]
        # Off the pixel's own, so that little numbers are fitted.
        off = inverse[around]
        off -= centre[:, None]
        same = np.abs(off) < (JUMP * centre**2)[:, None]
        same &= labels[around] == labels[at][:, None]
        a, b = self.tangents
        count, fitted = _planes(off, same, down * (b[1] - b[0]), across * (a[1] - a[0]))
        enough = count >= FEWEST
        a, b = a[columns[enough]], b[rows[enough]]
        q, slope_b, slope_a = fitted[:, enough]
        q += centre[enough]
        depth = 1.0 / q
        points = np.stack([a * depth, b * depth, depth], axis=1)
        normals = -np.stack([slope_a, slope_b, q - slope_a * a - slope_b * b], axis=1)
        normals /= np.sqrt((normals**2).sum(axis=1, keepdims=True))
        return labels[at[enough]], points, normals

    def _edges(self, rows: Ints, columns: Ints) -> NDArray[np.bool_]:
        """Which of the pixels (n,) have something else beside them, or the same much deeper."""
        height, width = self.labels.shape
        labels, depths, at = self.labels.ravel(), self.depths.ravel(), rows * width + columns
        own_labels, own_depths = labels[at], depths[at]
        edges = np.zeros(len(at), bool)
        # At the image's border a pixel is compared with itself.
        for beside in (
            at - (columns > 0),
            at + (columns < width - 1),
            at - width * (rows > 0),
            at + width * (rows < height - 1),
        ):
            edges |= labels[beside] != own_labels
            edges |= np.abs(depths[beside] - own_depths) > 2 * JUMP
        return edges


_NOTHING = -1


def _planes(
    values: Array, same: NDArray[np.bool_], down: Array, across: Array
) -> tuple[Array, Array]:
    """Least squares of values (n, k) over offsets (k,), where ``same``.

    Returns:
        How many went into each, shape (n,), and constant, slope down and slope across, (3, n).
    """
    reach = np.abs(down).max(), np.abs(across).max()
    down, across = down / reach[0], across / reach[1]
    basis = np.stack([np.ones_like(down), down, across])  # (3, k)
    products = np.concatenate([basis, [down * down, down * across, across * across]])  # (6, k)
    weights = same.astype(float)
    n, d, c, dd, dc, cc = products @ weights.T
    weights *= values
    first, second, third = basis @ weights.T
    # The normal equations, eliminated row by row: many small systems at once.
    dd = dd - d * d / n + _STEADY
    dc = dc - d * c / n
    second -= first * d / n
    third -= first * c / n + second * dc / dd
    across_slope = third / (cc - c * c / n - dc * dc / dd + _STEADY)
    down_slope = (second - dc * across_slope) / dd
    constant = (first - d * down_slope - c * across_slope) / n
    return n, np.stack([constant, down_slope / reach[0], across_slope / reach[1]])
