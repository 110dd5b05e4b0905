"""Cloud: the points of one object that cameras have seen."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Cloud:
    """What was seen of one object: points [m] and outward unit normals, both (n, 3), base frame."""

    points: Array
    normals: Array

    def __len__(self) -> int:
        return len(self.points)

    @classmethod
    def joined(cls, clouds: Sequence["Cloud"]) -> "Cloud":
        """All of them together."""
        return cls(
            np.concatenate([cloud.points for cloud in clouds]),
            np.concatenate([cloud.normals for cloud in clouds]),
        )

    @cached_property
    def lowest(self) -> Array:
        """The bounding box's lower corner, shape (3,) [m]."""
        return self.points.min(axis=0)

    @cached_property
    def highest(self) -> Array:
        """The bounding box's upper corner, shape (3,) [m]."""
        return self.points.max(axis=0)
