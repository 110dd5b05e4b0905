"""Closed-form kinematics of Universal Robots' arms: three parallel joints in the middle.

After K. P. Hawkins, "Analytic Inverse Kinematics for the Universal Robots UR-5/UR-10 Arms", Georgia
Institute of Technology, 2013, with the signs of the Denavit-Hartenberg convention
``Rz(q) Tz(d) Tx(a) Rx(alpha)``, alpha = (90, 0, 0, 90, -90, 0) degrees. ``a2`` and ``a3`` are
negative: with all angles 0 the arm lies along -x.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_SINGULAR = 1e-6
"""Where the sine of the fifth angle is smaller than this, the fourth and the sixth turn as one."""
_ROUNDING = 1e-9
"""A cosine may be beyond 1 by so much where the arm is stretched out."""


@dataclass(frozen=True, slots=True)
class UniversalKinematics:
    """One size of arm [m]."""

    d1: float
    a2: float
    a3: float
    d4: float
    d5: float
    d6: float

    def forward(self, joints: Array) -> Array:
        """The flange's pose in the base frame, shape (4, 4)."""
        pose = np.eye(4)
        for joint, d, a, sine in zip(
            joints.tolist(),
            (self.d1, 0.0, 0.0, self.d4, self.d5, self.d6),
            (0.0, self.a2, self.a3, 0.0, 0.0, 0.0),
            (1.0, 0.0, 0.0, 1.0, -1.0, 0.0),
            strict=True,
        ):
            pose = pose @ _link(joint, d, a, sine)
        return pose

    def inverse(self, flange: Array, last: float) -> Array:
        """All joint angles, in (-pi, pi], that bring the flange to a pose.

        Args:
            flange: its pose in the base frame, shape (4, 4).
            last: the sixth angle, where the pose leaves it open [rad].

        Returns:
            Up to eight solutions, shape (n, 6) [rad].
        """
        found = [
            (first, *middle, fifth, sixth)
            for first in self._first(flange)
            for fifth, sixth in self._wrist(flange, first, last)
            for middle in self._middle(flange, first, fifth, sixth)
        ]
        angles = np.array(found, float).reshape(-1, 6)
        return np.pi - (np.pi - angles) % (2 * np.pi)

    def _first(self, flange: Array) -> Iterator[float]:
        """The wrist's middle lies ``d4`` beside the plane the arm moves in, to either side."""
        x, y, _ = (flange[:3, 3] - self.d6 * flange[:3, 2]).tolist()
        cosine = self.d4 / max(math.hypot(x, y), 1e-12)
        if cosine <= 1.0:
            half = math.acos(cosine)
            yield from (math.atan2(y, x) + side * half + math.pi / 2 for side in (1, -1))

    def _wrist(self, flange: Array, first: float, last: float) -> Iterator[tuple[float, float]]:
        """The fifth and the sixth angle."""
        sine, cosine = math.sin(first), math.cos(first)
        x, y = float(flange[0, 3]), float(flange[1, 3])
        beside = (x * sine - y * cosine - self.d4) / self.d6
        if abs(beside) > 1.0 + _ROUNDING:
            return
        angle = math.acos(max(-1.0, min(1.0, beside)))
        for fifth in (angle, -angle):
            if abs(math.sin(fifth)) < _SINGULAR:
                yield fifth, last
                continue
            sign = math.copysign(1.0, math.sin(fifth))
            across = flange[0, :2] * sine - flange[1, :2] * cosine
            yield fifth, math.atan2(-sign * float(across[1]), sign * float(across[0]))

    def _middle(
        self, flange: Array, first: float, fifth: float, sixth: float
    ) -> Iterator[tuple[float, float, float]]:
        """The second to fourth angle: an arm of two links in a plane."""
        wrist = _link(fifth, self.d5, 0.0, -1.0) @ _link(sixth, self.d6, 0.0, 0.0)
        base = _link(first, self.d1, 0.0, 1.0)
        pose = np.linalg.inv(base) @ flange @ np.linalg.inv(wrist)  # frame 4 in frame 1
        x, y = float(pose[0, 3]), float(pose[1, 3])
        cosine = (x * x + y * y - self.a2**2 - self.a3**2) / (2 * self.a2 * self.a3)
        if abs(cosine) > 1.0 + _ROUNDING:
            return
        elbow = math.acos(max(-1.0, min(1.0, cosine)))
        total = math.atan2(float(pose[1, 0]), float(pose[0, 0]))
        for third in (elbow, -elbow):
            reach = math.atan2(self.a3 * math.sin(third), self.a2 + self.a3 * math.cos(third))
            second = math.atan2(y, x) - reach
            yield second, third, total - second - third


def _link(joint: float, d: float, a: float, sine: float) -> Array:
    """One row of the table; ``sine`` of alpha, which is 0 or a right angle."""
    s, c = math.sin(joint), math.cos(joint)
    cosine = 1.0 - abs(sine)
    return np.array(
        [
            [c, -s * cosine, s * sine, a * c],
            [s, c * cosine, -c * sine, a * s],
            [0.0, sine, cosine, d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
