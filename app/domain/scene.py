"""Scene: what is there, and what the robot can do."""

from dataclasses import dataclass, field

Position = tuple[float, float, float]
"""x forward, y to the robot's left, z up from the table top [m]; origin at the robot's base."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneObject:
    """One object, as the client described it or, once completed by its world, as it stands.

    Only the name is needed: a world completes the rest (see ``WorldDescription.complete``).
    """

    name: str
    kind: str | None = None
    """A kind of the world's catalogue, or None for the name's best match."""
    category: str | None = None
    """What it is an instance of, as people say it: ``fruit``."""
    colour: str | None = None
    """A CSS colour name or ``#rrggbb``."""
    size: Position | None = None
    """Length, width, height of the bounding box at rest [m]."""
    container: bool = False
    """Other objects may be put into or onto it."""
    position: Position | None = None
    """Where its footprint's centre stands [m]; z is the height of its underside."""
    yaw: float | None = None
    """Rotation about z [rad]."""
    properties: tuple[tuple[str, str], ...] = ()
    """Whatever else is known of it, by name: ``("material", "wood")``."""

    @property
    def number(self) -> int:
        """How many it stands for, where it is a class of things."""
        told = dict(self.properties).get("number", "")
        return int(told) if told.isdecimal() else 1

    def members(self) -> tuple[str, ...]:
        """What each single one is called where it stands for several: ``plate 1``, ``plate 2``."""
        number = self.number
        return tuple(f"{self.name} {i + 1}" for i in range(number)) if number > 1 else ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """A world's name, the objects in it and the actions on offer."""

    world: str
    objects: tuple[SceneObject, ...] = ()
    actions: tuple[str, ...] | None = None
    """Names of the world's action primitives on offer; None for all of them."""
    environment: str | None = None
    """One of the world's ready-made environments, where it has any."""
    graph: str | None = None
    """An environment of the client's own as JSON, where the world takes one: nodes and edges."""
    robot: str | None = None
    """The arm that works there, by name, where the world has one; None for its usual one."""
    agent: str | None = None
    """What conditions call the one who acts, where the world tells of it: ``character``."""
    names: tuple[str, ...] = field(init=False, default=())
    """The objects' names, in order."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "names", tuple(item.name for item in self.objects))
