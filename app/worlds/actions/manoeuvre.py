"""Manoeuvre: what every motion of the arm has in common: its stages, its look, its way home."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import WIDEST_MARGIN
from app.worlds.simulators.mujoco.level import Level
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.picking import CLEARANCE
from app.worlds.simulators.mujoco.placing import Placing
from app.worlds.simulators.mujoco.workcell import Workcell

Array = NDArray[np.float64]

FREE_SPEED, CARRY_SPEED, CLOSE_SPEED, LIFT_SPEED = 1.0, 0.9, 0.8, 0.8
"""Fractions of the joints' limits: empty, loaded, close to objects, lifting and lowering."""
SQUEEZE_SECONDS, RELEASE_SECONDS, PAUSE = 0.3, 0.25, 0.05
CLOSING_SECONDS = 0.18
"""Of the squeeze and of the release, how long the fingers' target moves [s]."""
LONGEST_WAIT = 2.0
"""So long what was put down may go on moving before it is looked at [s]."""
EMPTY = 0.001
"""Fingers this close to the middle hold nothing [m]."""
BELOW_TABLE = -0.05
"""What is seen at this height has fallen off the table [m]."""
ON_THE_WAY = (WIDEST_MARGIN, 0.0)
"""Clearances of the arm on its way home, tried in turn, since it may start out close to something [m]."""


class Manoeuvre:
    """One object is worked with. Stages carry the number of the attempt."""

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str | None) -> None:
        self._cell = cell
        self._rng = rng
        self._item = item
        self._attempt = 1

    def _look_at(self, *names: str) -> dict[str, Cloud]:
        """Clouds of all that is seen, the named ones from close up.

        Raises:
            ActionFailure: one of those is not on the table any more, or not in view.
        """
        clouds = self._cell.look_at(*names)
        for name in names:
            if name not in clouds:
                raise ActionFailure(
                    "look", f"{name} is hidden or has fallen off the table: no camera sees it"
                )
            if clouds[name].highest[2] < BELOW_TABLE:
                raise ActionFailure("look", f"{name} has fallen off the table")
        return clouds

    def come_home(self) -> Iterator[Stage]:
        """Open the gripper and bring the arm home, whatever state it was left in."""
        physics, manipulator = self._cell.physics, self._cell.manipulator
        if np.abs(physics.joints - physics.arm.home).max() > 0.02:
            collisions = self._cell.collisions
            if self._held():
                yield from self._during("release", manipulator.open())
            collisions.recall()
            yield from self._during("home", manipulator.follow(self._way_home(), FREE_SPEED))
        if physics.commanded_opening < physics.arm.largest_opening - 1e-9:
            yield from self._during("home", manipulator.open())

    def _way_home(self) -> Array:
        """Corner points of the way, shape (n, joints) [rad]: straight where none is found."""
        physics, collisions = self._cell.physics, self._cell.collisions
        start, home, opening = physics.joints, physics.arm.home, physics.opening
        for clearance in ON_THE_WAY:

            def blocked(joints: Array, clearance: float = clearance) -> bool:
                return collisions.find(joints, opening, clearance) is not None

            path = free_path(physics.arm, start, home, blocked, self._rng)
            if path is not None:
                return path
        return np.array([start, home])

    def _go_home_loaded(self, item: str) -> Iterator[Stage]:
        """Bring the arm home with an object in the gripper.

        Raises:
            ActionFailure: there is no way without hitting something, or it was lost on the way.
        """
        physics, collisions = self._cell.physics, self._cell.collisions
        collisions.refresh()
        opening = physics.opening
        level = Level(physics, item) if item in physics.beads else None

        def blocked(joints: Array) -> bool:
            spills = level is not None and level.lost(joints)
            return spills or collisions.find(joints, opening, CLEARANCE) is not None

        with collisions.carrying(item):
            path = free_path(physics.arm, physics.joints, physics.arm.home, blocked, self._rng)
        if path is None:
            raise ActionFailure("home", f"no path home with {item} was found")
        yield from self._during("home", self._cell.manipulator.follow(path, CARRY_SPEED))
        if not self._held():
            raise ActionFailure("home", f"slipped: {item} was lost on the way")

    def _come_to_rest(self) -> Iterator[Stage]:
        """Wait until nothing moves any more, or for ``LONGEST_WAIT``."""
        physics = self._cell.physics
        deadline = physics.time + LONGEST_WAIT
        yield from self._during("check", self._cell.manipulator.wait(0.25))
        while not physics.resting() and physics.time < deadline:
            yield from self._during("check", self._cell.manipulator.wait(0.1))

    def _placing(self) -> Placing:
        return Placing(self._cell.physics, self._cell.collisions, self._rng)

    def _held(self) -> bool:
        if self._item is None:
            return False
        return self._cell.relations.holds(Relation("held", (self._item,)))

    def _stage(self, name: str) -> Stage:
        return Stage(name=name, attempt=self._attempt)

    def _during(self, name: str, motion: Iterator[None]) -> Iterator[Stage]:
        """The same stage at every look-in of a motion."""
        stage = self._stage(name)
        yield stage
        for _ in motion:
            yield stage
