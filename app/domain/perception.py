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
    detector: Literal["segmentation", "vision"] = "segmentation"
    """Who tells the cameras what they see: the simulator, which knows, or a vision model."""
    confusion: float = 0.0
    """The share of objects that are taken for another one, in [0, 1]."""


NO_VISION = (
    "there is no vision model: start the service with PROGPROMPT_VISION_URL and "
    "PROGPROMPT_VISION_MODEL, or leave the detector out"
)
"""What is said to who asks for the detector ``vision`` in vain."""
