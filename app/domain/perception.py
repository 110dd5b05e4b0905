"""Perception: how a robot comes to know what is around it."""

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True, kw_only=True)
class Perception:
    """What a world tells its robot of the objects; whether a plan succeeded is never told by it."""

    source: Literal["cameras", "privileged"] = "cameras"
    """Depth cameras alone, or the simulator's own geometry and poses."""
    noise: float = 0.002
    """Standard deviation of a camera's depth [m]; privileged cameras have none."""
    confusion: float = 0.0
    """The share of objects that are taken for another one, in [0, 1]."""
