"""Assets as clients see them."""

from datetime import datetime

from pydantic import Field

from app.api.schemas.base import Shown


class AssetShown(Shown):
    """A client's own mesh or body, ready to stand in scenes."""

    id: str
    kind: str = Field(description="What an object of a scene gives as its `kind`.")
    created_at: datetime
    name: str
    category: str
    colour: str
    size: tuple[float, float, float] = Field(
        description="Length, width, height of its bounding box [m]."
    )
    density: float = Field(description="Of what of it collides [kg/m³].")
    mass: float = Field(description="[kg]")
    faces: int = Field(description="Triangles that are seen.")
    parts: int = Field(description="Convex parts and primitives that collide.")
    file_bytes: int = Field(description="Of the file that was sent.")
    graspable: bool = Field(
        description="Whether its narrower side fits between the fingers; else it only stands there."
    )
