"""Opening: the inside of a container."""

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True, kw_only=True)
class Opening:
    """Where things lie in a container, in its body's frame, centred on the frame's z axis."""

    shape: Literal["round", "box"]
    half_extents: tuple[float, float]
    """Along x and y [m]; of a round opening both are its radius."""
    floor: float
    """Height of the inner floor [m]."""
    rim: float
    """Height of the upper edge [m]."""
    flat: bool = False
    """A plate or a tray: what is in it is also on it."""

    @property
    def radius(self) -> float:
        """Of the largest disc that fits [m]."""
        return min(self.half_extents)
