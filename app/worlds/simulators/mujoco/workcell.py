"""Workcell: the table with the arm, its cameras, and all that an action works with."""

from dataclasses import dataclass

from app.worlds.simulators.mujoco.cameras import Cameras, Cloud
from app.worlds.simulators.mujoco.collision import Collisions
from app.worlds.simulators.mujoco.panda import Panda
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.relations import Relations
from app.worlds.simulators.mujoco.scene_builder import BuiltScene


@dataclass(frozen=True, slots=True, eq=False)
class Workcell:
    """Everything about one running scene."""

    physics: Physics
    panda: Panda
    cameras: Cameras
    collisions: Collisions
    relations: Relations

    @classmethod
    def over(cls, built: BuiltScene) -> "Workcell":
        """The workcell of a built scene."""
        physics = Physics(built)
        return cls(
            physics,
            Panda(physics),
            Cameras(physics),
            Collisions(physics),
            Relations(physics),
        )

    def look_at(self, *names: str) -> dict[str, Cloud]:
        """Clouds of what is seen, the named ones and what is next to them from close up."""
        seen = self.cameras.overview()
        finest = dict(seen)
        for name in names:
            if name in seen:
                for other, cloud in self.cameras.close_up(seen[name]).items():
                    # At the edge of a close-up, only a part of a neighbour may be in view.
                    finest[other] = max(cloud, finest.get(other, cloud), key=len)
        return finest
