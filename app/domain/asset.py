"""Asset: a client's own mesh, taken in once and then a kind of object in any scene."""

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
    """Of its convex parts [kg/m³]."""
    size: tuple[float, float, float]
    """Length, width, height of the bounding box [m]."""
    shape: bytes
    """The mesh and its convex parts, as the simulator packs them."""
