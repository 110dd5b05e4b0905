"""Asset: a client's own mesh or body, taken in once and then a kind of object in any scene."""

from dataclasses import dataclass

ASSET = "asset:"
"""What an object's ``kind`` begins with where an asset's id follows."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asset:
    """A solid with fixed measures; whatever makes it up decides its id, so it never changes."""

    id: str
    name: str
    """What people call it, singular."""
    category: str
    colour: str
    """A CSS colour name or ``#rrggbb``."""
    density: float
    """Of what of it collides [kg/m³]."""
    size: tuple[float, float, float]
    """Length, width, height of the bounding box [m]."""
    shape: bytes
    """What is seen of it and what collides, as the simulator packs them."""
