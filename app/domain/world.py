"""World: what a plan acts on; WorldDescription: what it offers before anything runs."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

from app.domain.action import ActionSignature
from app.domain.condition import Relation
from app.domain.perception import Perception
from app.domain.program import Argument
from app.domain.scene import Scene
from app.domain.trace import Frame


@dataclass(frozen=True, slots=True, kw_only=True)
class Stage:
    """An action came to its next stage, or goes on with it: the caller may look in or stop."""

    name: str
    attempt: int = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class ObjectKind:
    """An entry of a world's catalogue."""

    name: str
    category: str
    synonyms: tuple[str, ...]
    container: bool
    size: tuple[float, float, float]
    """Length, width, height of the bounding box at rest, middle of its range [m]."""
    colour: str


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotKind:
    """A robot that a scene of a world can name."""

    name: str
    title: str
    joints: int
    """Of its arm."""
    default: bool
    """Whether it works where a scene names none."""


class World(Protocol):
    """One scene standing ready, or in the middle of being worked on."""

    scene: Scene
    """Completed: every object has its kind, size and place."""

    @property
    def time(self) -> float:
        """Simulated time since the rollout began [s]."""
        ...

    def perform(self, action: str, arguments: tuple[Argument, ...]) -> Iterator[Stage]:
        """Carry out one action; yields its stages, and at least every 0.2 s of simulated time.

        Raises:
            ActionFailure: it did not succeed; the world is left safe for the next action.
        """
        ...

    def holds(self, relation: Relation) -> bool:
        """Whether the relation is true as things stand now."""
        ...

    def facts(self) -> frozenset[Relation]:
        """What is true now, of the relations worth telling (not every left_of and near)."""
        ...

    def settle(self) -> None:
        """Let everything come to rest."""
        ...

    def frames(self) -> tuple[Frame, ...]:
        """The frames recorded since the last call; a world without motion has none."""
        ...

    def save(self) -> bytes:
        """The whole state, such that ``restore`` continues bit for bit."""
        ...

    def restore(self, state: bytes) -> None:
        """Take up a state that ``save`` gave for the same scene and seed."""
        ...

    def begin(self) -> None:
        """Call it time 0, with no frames waiting: what follows is a rollout of its own."""
        ...


class WorldDescription(Protocol):
    """A kind of world, as the catalogue lists it."""

    name: str
    actions: tuple[ActionSignature, ...]
    default_actions: tuple[str, ...]
    """Names of the actions on offer where a scene names none."""
    relations: dict[str, int]
    """The relations it can decide, with their number of arguments."""
    moves: bool
    """Whether its rollouts have frames of a model to show."""
    feedback: bool
    """Whether its example programs hold assertions unless asked otherwise, as in the paper."""
    planner: str
    """Name of the planner that does best in it."""

    robots: tuple[RobotKind, ...]
    """Those a scene can name; none where who acts is no robot arm."""

    def environments(self) -> tuple[str, ...]:
        """Names of the ready-made ones a scene can name, the usual one first; a table has none."""
        ...

    def catalogue(self) -> tuple[ObjectKind, ...]:
        """The object kinds it knows."""
        ...

    def complete(self, scene: Scene, seed: int) -> Scene:
        """The scene with everything its client left open filled in; the same seed, the same scene.

        Raises:
            SceneRefused: it cannot be built; every fault names its field.
        """
        ...

    def model(self, scene: Scene) -> object:
        """What is drawn of its rollouts, where it ``moves``: a model of the completed scene.

        Its coordinates are the positions of the frames. What it is beyond that is known to whoever
        makes it and to whoever draws it (a ``mujoco.MjModel``), not here.
        """
        ...

    def open(self, scene: Scene, seed: int, perception: Perception = ...) -> World:
        """A world with this scene (completed or not) in it, at rest, time 0."""
        ...

    def open_perfect(self, scene: Scene, seed: int, state: bytes | None = None) -> World:
        """The same scene in the perfect executor: facts only, every admissible action succeeds.

        ``state`` is what a world of ``open`` saved: the perfect executor begins there.
        """
        ...


@runtime_checkable
class Reversible(Protocol):
    """A kind of world where taking back needs actions that nobody asks for otherwise."""

    reversing_actions: tuple[str, ...]
    """Names of actions on offer besides the default ones to a plan that follows another, where the
    scene names none."""
