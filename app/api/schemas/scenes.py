"""Scenes as clients write them."""

import json
from datetime import datetime
from typing import Annotated, Any

from pydantic import BaseModel, Field, field_validator

from app.api.schemas.base import Given, Shown, Text
from app.domain.scene import Scene, SceneObject

MAX_OBJECTS = 500
Metres = Annotated[float, Field(ge=-100, le=100)]
Size = Annotated[float, Field(gt=0, le=100)]
Name = Annotated[Text, Field(min_length=1, max_length=100)]


class ObjectGiven(Given):
    """One object; only its name is needed."""

    name: Name = Field(description="Unique in its scene; what programs and goals call it.")
    kind: Name | None = Field(
        default=None,
        description="A kind of the catalogue; default the name's best match, else a box.",
    )
    category: Name | None = Field(
        default=None, description="What it is an instance of, like `fruit`."
    )
    colour: Name | None = Field(default=None, description="A CSS colour name or `#rrggbb`.")
    size: tuple[Size, Size, Size] | None = Field(
        default=None, description="Length, width, height of its bounding box at rest [m]."
    )
    container: bool = Field(default=False, description="Whether others may be put into or onto it.")
    position: list[Metres] | None = Field(
        default=None,
        min_length=2,
        max_length=3,
        description="Where its footprint's centre stands, x, y and optionally the height z of its "
        "underside [m], in the table frame; sampled free of collision where missing.",
    )
    yaw: Annotated[float, Field(ge=-1000, le=1000)] | None = Field(
        default=None, description="Rotation about the vertical [rad]."
    )
    properties: dict[Name, Name] = Field(
        default_factory=dict,
        max_length=20,
        description='Whatever else is known of it, for the planner: `{"material": "wood"}`.',
    )

    def to_domain(self) -> SceneObject:
        """The object."""
        values = self.model_dump(exclude={"position", "properties"})
        position = None if self.position is None else tuple((*self.position, 0.0)[:3])
        properties = tuple(self.properties.items())
        return SceneObject(**values, position=position, properties=properties)  # pyright: ignore[reportArgumentType]


MAX_NODES, MAX_EDGES = 2000, 20_000
Identifier = Annotated[int, Field(ge=0, le=2**31)]


class BoxGiven(BaseModel):
    """A bounding box along the axes, y up, as VirtualHome has it [m]."""

    center: tuple[Metres, Metres, Metres]
    size: tuple[Size, Size, Size]


class NodeGiven(BaseModel):
    """A thing in a home; whatever else VirtualHome tells of it is passed over."""

    id: Identifier
    class_name: Name = Field(description="What programs and goals call all of its class.")
    category: Annotated[Text, Field(max_length=100)] = Field(
        default="", description="`Rooms` for a room, `Food` for what can be heated."
    )
    properties: list[Name] = Field(
        default_factory=list, max_length=40, description="`GRABBABLE`, `CAN_OPEN`, `HAS_SWITCH` …"
    )
    states: list[Name] = Field(
        default_factory=list, max_length=20, description="`OPEN` or `CLOSED`, `ON` or `OFF` …"
    )
    bounding_box: BoxGiven | None = None


class EdgeGiven(BaseModel):
    """How one thing stands to another."""

    from_id: Identifier
    relation_type: Name = Field(description="`INSIDE`, `ON`, `CLOSE`, `FACING`, `HOLDS_RH` …")
    to_id: Identifier


class GraphGiven(BaseModel):
    """A home of one's own in VirtualHome's own JSON."""

    nodes: list[NodeGiven] = Field(max_length=MAX_NODES)
    edges: list[EdgeGiven] = Field(max_length=MAX_EDGES)


class SceneGiven(Given):
    """What stands there, and what the robot can do with it."""

    world: Name = Field(default="tabletop", description="A world of the catalogue.")
    objects: list[ObjectGiven] = Field(
        default_factory=list, max_length=MAX_OBJECTS, description="The objects, in any order."
    )
    actions: list[Name] | None = Field(
        default=None,
        min_length=1,
        max_length=100,
        description="Names of the world's action primitives on offer; null for its usual ones.",
    )
    environment: Name | None = Field(
        default=None, description="One of the world's ready-made environments, where it has any."
    )
    graph: GraphGiven | None = Field(
        default=None, description="A household of one's own, in place of a ready-made environment."
    )

    robot: Name | None = Field(
        default=None, description="A robot of the catalogue; default the world's usual one."
    )

    def to_domain(self) -> Scene:
        """The scene."""
        return Scene(
            world=self.world,
            objects=tuple(item.to_domain() for item in self.objects),
            actions=None if self.actions is None else tuple(self.actions),
            environment=self.environment,
            robot=self.robot,
            graph=None if self.graph is None else self.graph.model_dump_json(exclude_none=True),
        )


class ObjectShown(Shown):
    """One object, everything its client left open filled in."""

    name: str
    kind: str | None
    category: str | None
    colour: str | None
    size: tuple[float, float, float] | None
    container: bool
    position: tuple[float, float, float] | None
    yaw: float | None
    properties: dict[str, str] = Field(default_factory=dict)

    @field_validator("properties", mode="before")
    @classmethod
    def _as_object(cls, given: object) -> object:
        """Stored as pairs, since a scene of the domain is a value."""
        return dict(given) if isinstance(given, list | tuple) else given


class SceneShown(Shown):
    """A scene, completed by its world."""

    world: str
    objects: list[ObjectShown]
    actions: list[str] | None
    environment: str | None
    robot: str | None = None
    graph: dict[str, Any] | None = None

    @field_validator("graph", mode="before")
    @classmethod
    def _as_graph(cls, given: object) -> object:
        """Stored as text, since a scene of the domain is a value."""
        return json.loads(given) if isinstance(given, str) else given


class SceneStored(SceneShown):
    """A scene kept for later plans, as its client described it."""

    id: str = Field(description="For `scene_id` of a plan.")
    created_at: datetime


class SceneValidated(Shown):
    """A scene that can be planned in."""

    valid: bool = Field(description="Always true; what is not valid is a problem document.")
    scene: SceneShown = Field(description="The scene as its world completes it from the seed.")
