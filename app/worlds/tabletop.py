"""Tabletop: a table of objects and a robot arm, in MuJoCo."""

import struct
from collections.abc import Callable, Iterator

import mujoco
import numpy as np

from app.domain.asset import Asset
from app.domain.condition import Relation
from app.domain.errors import ActionFailure, Fault, Refused
from app.domain.perception import NO_VISION, Perception
from app.domain.program import Argument
from app.domain.scene import Scene
from app.domain.sighting import Finder
from app.domain.trace import Frame
from app.domain.world import ObjectKind, RobotKind, Stage, World
from app.worlds import worlds
from app.worlds.actions.tabletop import actions as primitives
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms
from app.worlds.simulators.mujoco.detector import Detector
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picture import Pictures
from app.worlds.simulators.mujoco.placement import complete
from app.worlds.simulators.mujoco.relations import RELATIONS, Relations
from app.worlds.simulators.mujoco.scene_builder import BuiltScene, build
from app.worlds.simulators.mujoco.vision import Vision
from app.worlds.simulators.mujoco.workcell import Workcell
from app.worlds.simulators.symbolic import SymbolicWorld

DEFAULT_PERCEPTION = Perception()
_COUNT = struct.Struct("<Q")


@worlds.register("tabletop")
class Tabletop:
    """The description of the tabletop, and where its worlds are opened."""

    name = "tabletop"
    relations = RELATIONS
    moves = True
    feedback = False
    planner = "situated"

    actions = tuple(action.signature for action in primitives.values())
    default_actions: tuple[str, ...] = ("grab_and_putin",)
    reversing_actions: tuple[str, ...] = ("place_at",)

    robots = tuple(
        RobotKind(name=name, title=arm.title, joints=arm.joints, default=name == DEFAULT_ARM)
        for name, arm in arms.items()
    )

    def __init__(self) -> None:
        self._finder: Finder | None = None

    def environments(self) -> tuple[str, ...]:
        """None: a scene lists what stands on its table."""
        return ()

    def catalogue(self) -> tuple[ObjectKind, ...]:
        """The object kinds it knows."""
        return tuple(kind.entry() for kind in kinds.values())

    def assets(self, find: Callable[[str], Asset | None]) -> None:
        """Look up by ``find`` the meshes that scenes name as ``asset:<id>``."""
        kinds.assets.search(find)

    def look_with(self, finder: Finder | None) -> None:
        """Let the detector ``vision`` ask this one; with None there is none."""
        self._finder = finder

    def complete(self, scene: Scene, seed: int) -> Scene:
        """The scene with kinds, sizes, colours and places for all objects."""
        return complete(scene, seed)

    def model(self, scene: Scene) -> mujoco.MjModel:
        """The table with the arm and what stands on it; its ``qpos`` are the frames' positions."""
        return build(scene).model

    def open(
        self, scene: Scene, seed: int, perception: Perception = DEFAULT_PERCEPTION
    ) -> "TabletopWorld":
        """The scene in physics, settled, at time 0; its robot sees as ``perception`` tells."""
        if perception.detector == "vision" and self._finder is None:
            raise Refused(Fault(field="perception.detector", message=NO_VISION))
        return TabletopWorld(complete(scene, seed), seed, perception, self._finder)

    def open_perfect(self, scene: Scene, seed: int, state: bytes | None = None) -> World:
        """The scene's facts as it is described, or as it was saved, without a step of physics."""
        scene = complete(scene, seed)
        built = build(scene, visuals=False)
        physics = Physics(built)
        if state is not None:
            physics.restore(state[_COUNT.size :])
        relations = Relations(physics)
        facts = relations.every_fact() | _affordances(built, relations)
        facts |= {Relation("level", (name,)) for name in built.bodies if physics.is_level(name)}
        return SymbolicWorld(scene, facts, primitives)


class TabletopWorld:
    """One scene in physics.

    Every action draws from its own stream of random numbers, told by the seed and by how many
    actions went before, so that a restored world goes on as it would have.
    """

    def __init__(
        self, scene: Scene, seed: int, perception: Perception, finder: Finder | None = None
    ) -> None:
        self.scene = scene
        self._seed = seed % 2**63
        self._performed = 0

        def seeing(physics: Physics) -> Detector:
            assert finder is not None
            pictures = Pictures(physics, lambda: build(scene).model)
            return Vision(physics, pictures, finder, scene.names)

        detecting = seeing if perception.detector == "vision" else None
        built = build(scene, visuals=False)
        self._cell = Workcell.over(built, perception, self._seed, detecting)
        self.physics = self._cell.physics
        self.physics.begin()

    @property
    def time(self) -> float:
        """Simulated time since the rollout began [s]."""
        return self.physics.time

    def perform(self, action: str, arguments: tuple[Argument, ...]) -> Iterator[Stage]:
        """Carry out one action, yielding its stages every 0.1 s of simulated time.

        Raises:
            ActionFailure: it did not succeed; the gripper is open and the arm at home.
        """
        parameters = primitives[action].signature.parameters
        for parameter, argument in zip(parameters, arguments, strict=True):
            named = parameter.role not in ("number", "word")
            if named and argument not in self.physics.bodies:
                raise ActionFailure("look", f"there is no {argument} in the scene")
        rng = np.random.default_rng((self._seed, self._performed))
        self._performed += 1
        self.physics.wake()
        yield from primitives[action].perform(self._cell, rng, *map(str, arguments))

    def holds(self, relation: Relation) -> bool:
        """Whether the relation is true as things stand now."""
        return self._cell.truth.holds(relation)

    def facts(self) -> frozenset[Relation]:
        """Every ``in``, ``on`` and ``held`` that is true now, and what can be shut: open or closed."""
        return self._cell.truth.facts()

    def place(self, name: str) -> tuple[float, float]:
        """Where an object's middle is, base frame [m]."""
        x, y = self._cell.truth.place(name)
        return float(x), float(y)

    def settle(self) -> None:
        """Go on until every object rests."""
        self.physics.settle()

    def frames(self) -> tuple[Frame, ...]:
        """The frames sampled since the last call, 30 for a second of simulated time."""
        return self.physics.frames()

    def save(self) -> bytes:
        """The physics' state and the number of actions begun; to be called between actions."""
        return _COUNT.pack(self._performed) + self.physics.save()

    def restore(self, state: bytes) -> None:
        """Take up what ``save`` gave for the same scene and seed."""
        (self._performed,) = _COUNT.unpack_from(state)
        self.physics.restore(state[_COUNT.size :])

    def begin(self) -> None:
        """Call it time 0: what follows is a rollout of its own."""
        self.physics.rewind()


def _affordances(built: BuiltScene, relations: Relations) -> frozenset[Relation]:
    """What decides what an action does: ``container(a)``, ``flat(a)``, ``shuts(a)``, ``at(a, x, y)``."""
    containers = [body for body in built.bodies.values() if body.opening is not None]
    facts = {Relation("container", (body.name,)) for body in containers}
    facts |= {Relation("flat", (b.name,)) for b in containers if b.opening and b.opening.flat}
    facts |= {Relation("shuts", (name,)) for name, b in built.bodies.items() if b.articulation}
    for name in built.bodies:
        x, y = relations.place(name)
        facts.add(Relation("at", (name, f"{x:.4f}", f"{y:.4f}")))
    return frozenset(facts)
