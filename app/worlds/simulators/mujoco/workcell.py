"""Workcell: the table with the arm, its cameras, and all that an action works with."""

from collections.abc import Callable
from dataclasses import dataclass

from app.domain.perception import Perception
from app.worlds.simulators.mujoco.beliefs import Beliefs
from app.worlds.simulators.mujoco.cameras import Cameras
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.detector import Detector
from app.worlds.simulators.mujoco.known_collisions import KnownCollisions
from app.worlds.simulators.mujoco.manipulator import Manipulator
from app.worlds.simulators.mujoco.outline import KnownOutlines, Outlines, SeenOutlines
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.relations import Relations
from app.worlds.simulators.mujoco.scene_builder import BuiltScene
from app.worlds.simulators.mujoco.seen_collisions import SeenCollisions


@dataclass(frozen=True, slots=True, eq=False)
class Workcell:
    """Everything about one running scene."""

    physics: Physics
    manipulator: Manipulator
    cameras: Cameras
    collisions: Collisions
    outlines: Outlines
    relations: Relations | Beliefs
    """What the robot takes to be true."""
    truth: Relations
    """What is true; for scoring, not for the robot."""

    @classmethod
    def over(
        cls,
        built: BuiltScene,
        perception: Perception | None = None,
        seed: int = 0,
        detecting: Callable[[Physics], Detector] | None = None,
    ) -> "Workcell":
        """The workcell of a built scene.

        Args:
            built: the scene.
            perception: how the robot sees; None for privileged perception.
            seed: of the cameras' noise and confusions.
            detecting: what the cameras' detector is made by; None for the segmentation.
        """
        perception = perception or Perception(source="privileged")
        physics = Physics(built)
        detector = detecting(physics) if detecting else None
        cameras, truth = Cameras(physics, perception, seed, detector), Relations(physics)
        if perception.source == "privileged":
            collisions, outlines, relations = (
                KnownCollisions(physics),
                KnownOutlines(physics),
                truth,
            )
        else:
            collisions = SeenCollisions(physics, cameras)
            outlines, relations = SeenOutlines(), Beliefs(physics, cameras, truth)
        manipulator = Manipulator(physics)
        return cls(physics, manipulator, cameras, collisions, outlines, relations, truth)

    def look_at(self, *names: str) -> dict[str, Cloud]:
        """Clouds of what is seen, the named ones and what is next to them from close up."""
        return self.cameras.look(*names)
