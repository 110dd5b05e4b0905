"""Household: a home of rooms, furniture and things, as a graph; the paper's symbolic environment."""

import json
import random
from collections.abc import Iterator
from pathlib import Path

import mujoco

from app.domain.condition import Relation
from app.domain.errors import Fault, SceneRefused, UnknownName
from app.domain.perception import Perception
from app.domain.program import Argument
from app.domain.scene import Scene
from app.domain.trace import Frame
from app.domain.world import ObjectKind, Stage
from app.worlds import worlds
from app.worlds.actions.household import actions as primitives
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_facts import RELATIONS, facts, holds
from app.worlds.simulators.household_film import HouseholdFilm
from app.worlds.simulators.household_graph import AGENT, HouseholdGraph
from app.worlds.simulators.household_homes import FIRST, SHIPPED, HouseholdHomes
from app.worlds.simulators.household_instances import Instances
from app.worlds.simulators.household_model import HomeModel
from app.worlds.simulators.household_states import derive
from app.worlds.simulators.household_things import things

PAPER = (
    "find", "walk", "grab", "putin", "putback", "open", "close", "switchon", "switchoff",
    "sit", "standup",
)  # fmt: skip
"""The verbs of the paper's household, in the order of its import line."""
_KNOWN = Perception(source="privileged")
_TICK = 0.2
"""So much of the film passes between two looks at the world [s]."""


@worlds.register("household")
class Household:
    """The description of the household, and where its worlds are opened."""

    name = "household"
    relations = RELATIONS
    moves = True
    feedback = True
    planner = "activities"
    actions = tuple(
        primitives[name].signature
        for name in (*PAPER, *(name for name in primitives if name not in PAPER))
    )
    default_actions = PAPER
    robots = ()

    def __init__(self) -> None:
        self._homes = HouseholdHomes()

    def homes(self, folder: Path | None) -> None:
        """Take the environments from this folder, or with None those that ship with the product.

        Raises:
            UnknownName: the folder holds no environment.
        """
        self._homes = HouseholdHomes(folder or SHIPPED)
        if not self.environments():
            raise UnknownName("folder of homes", str(self._homes.folder), [str(SHIPPED)])

    def environments(self) -> tuple[str, ...]:
        """The names that ``environment`` of a scene may have."""
        return self._homes.names()

    def catalogue(self) -> tuple[ObjectKind, ...]:
        """Every class of thing in any of the homes, with its bounding box."""
        return self._homes.catalogue()

    def complete(self, scene: Scene, seed: int) -> Scene:
        """The scene with its environment named and all its classes of things listed.

        A scene that lists objects offers only these to the planner; the others are there as well.

        Raises:
            SceneRefused: the environment, the graph or an object is not to be had.
        """
        del seed  # Nothing is left to chance.
        graph = self.graph(scene)
        described = {each.name: each for each in things(graph)}
        faults = [
            Fault(
                field=f"scene.objects.{index}.name",
                message=f"there is no {item.name[:80]!r} in this home; there is: "
                + ", ".join(sorted(described)),
            )
            for index, item in enumerate(scene.objects)
            if item.name not in described
        ]
        if scene.robot is not None:
            message = "is no choice here: a character acts in a home; leave it out"
            faults.append(Fault(field="scene.robot", message=message))
        if faults:
            raise SceneRefused(*faults)
        chosen = [described[item.name] for item in scene.objects] or described.values()
        environment = None if scene.graph is not None else scene.environment or FIRST
        return Scene(
            world=scene.world,
            objects=tuple(chosen),
            agent=AGENT,
            actions=scene.actions,
            environment=environment,
            graph=scene.graph,
        )

    def graph(self, scene: Scene) -> HouseholdGraph:
        """The home of the scene as it is at first.

        Raises:
            SceneRefused: it names no home, or its own graph is none.
        """
        return self._homes.graph(scene)

    def model(self, scene: Scene) -> mujoco.MjModel:
        """The home with the character in it; its ``qpos`` are the frames' positions."""
        return HomeModel(self.graph(scene)).compile()

    def open(self, scene: Scene, seed: int, perception: Perception = _KNOWN) -> "HouseholdWorld":
        """A world with this scene in it, and with frames of what it looks like."""
        del perception  # The graph is known.
        return HouseholdWorld(self.complete(scene, seed), self.graph(scene), seed, filmed=True)

    def open_perfect(self, scene: Scene, seed: int, state: bytes | None = None) -> "HouseholdWorld":
        """The same without frames, for which no time passes: nothing ever slips in a home."""
        world = HouseholdWorld(self.complete(scene, seed), self.graph(scene), seed)
        if state is not None:
            world.restore(state)
        return world

    def open_official(self, scene: Scene, seed: int) -> "HouseholdWorld":
        """As in the paper's release: things are found by chance, told by the seed."""
        return HouseholdWorld(self.complete(scene, seed), self.graph(scene), seed, official=True)


class HouseholdWorld:
    """One home in which somebody acts, and never slips."""

    def __init__(
        self,
        scene: Scene,
        graph: HouseholdGraph,
        seed: int,
        *,
        official: bool = False,
        filmed: bool = False,
    ) -> None:
        """Begin with a completed scene and its graph, which becomes this world's own.

        The ``official`` rules are those of the paper's release, to compare with its tables. A
        world that is ``filmed`` has frames; in any other no time passes.
        """
        self.scene = scene
        self.graph = graph
        self.agent = HouseholdAgent(graph, official=official)
        self._seed = seed
        self._begun = 0
        self._rng = random.Random() if official else None
        self._instances = Instances(self.agent, self._rng)
        self._film = HouseholdFilm(self.agent, HomeModel(graph)) if filmed else None
        self._time = 0.0
        derive(graph, official=official)

    @property
    def time(self) -> float:
        """Time since the rollout began, as the film has it [s]."""
        return self._time

    def perform(self, action: str, arguments: tuple[Argument, ...]) -> Iterator[Stage]:
        """Do it with the things that are meant; yields every 0.2 s of the film.

        Raises:
            ActionFailure: it cannot be done; nothing has changed.
        """
        yield Stage(name=action)
        self._begun += 1
        if self._rng is not None:
            self._rng.seed(self._seed * 1_000_003 + self._begun)
        primitive = primitives[action]
        chosen = self._instances.choose(action, primitive.check, tuple(map(str, arguments)))
        if self._film is not None:
            self._film.approach(chosen)
        primitive.apply(self.agent, *chosen)
        derive(self.graph, official=self.agent.official)
        if self._film is not None:
            self._film.add(chosen)
            while self._time < self._film.time:
                self._time = min(self._time + _TICK, self._film.time)
                yield Stage(name=action)

    def holds(self, relation: Relation) -> bool:
        """Whether the relation is true of any things of these names."""
        return holds(self.agent, relation)

    def facts(self) -> frozenset[Relation]:
        """States, what is held, and what is in or on what."""
        return frozenset(facts(self.agent))

    def settle(self) -> None:
        """Nothing moves by itself."""

    def frames(self) -> tuple[Frame, ...]:
        """The frames since the last call, ten a second; none where nothing is filmed."""
        return self._film.frames(self._time) if self._film is not None else ()

    def save(self) -> bytes:
        """States, edges, what was used last, and how it looks; to be called between actions."""
        chosen = [self._instances.used, sorted(self._instances.shunned)]
        film = self._film.save() if self._film is not None else None
        return json.dumps([self._begun, chosen, self.graph.save(), film]).encode()

    def restore(self, state: bytes) -> None:
        """Take up what ``save`` gave, of a filmed world or of one that is not."""
        self._begun, (used, shunned), graph, film = json.loads(state)
        self._instances.used, self._instances.shunned = used, set(shunned)
        self.graph.restore(graph)
        if self._film is None:
            return
        if film is None:
            self._film.catch_up()
        else:
            self._film.restore(film)
            self._time = self._film.time

    def begin(self) -> None:
        """Call it time 0, with no frames waiting."""
        self._time = 0.0
        if self._film is not None:
            self._film.rewind()
