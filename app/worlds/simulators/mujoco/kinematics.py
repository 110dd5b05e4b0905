"""Poses: homogeneous transforms as the domain has them."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from app.domain.pose import Pose

Array = NDArray[np.float64]


def pose(tool: Array) -> Pose:
    """A homogeneous transform, shape (4, 4), as position and quaternion."""
    x, y, z = tool[:3, 3].tolist()
    a, b, c, d = Rotation.from_matrix(tool[:3, :3]).as_quat(scalar_first=True).tolist()
    return Pose(position=(x, y, z), quaternion=(a, b, c, d))
