"""Pick and place: look, take hold, lift, carry, put down, check; again where it went wrong."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.simulators.mujoco.cameras import Cloud
from app.worlds.simulators.mujoco.destination import Destination
from app.worlds.simulators.mujoco.grasp import Grasp
from app.worlds.simulators.mujoco.kinematics import HOME
from app.worlds.simulators.mujoco.motion import free_path
from app.worlds.simulators.mujoco.physics import LARGEST_OPENING
from app.worlds.simulators.mujoco.picking import Pick, Picking
from app.worlds.simulators.mujoco.placing import Placing
from app.worlds.simulators.mujoco.workcell import Workcell

Array = NDArray[np.float64]
Grasps = list[Grasp]

ATTEMPTS = 3
FREE_SPEED, CARRY_SPEED, CLOSE_SPEED, LIFT_SPEED = 1.0, 0.7, 0.4, 0.5
"""Fractions of the joints' limits: empty, loaded, close to objects, lifting and lowering."""
SQUEEZE_SECONDS, RELEASE_SECONDS, PAUSE = 0.45, 0.35, 0.05
CLOSING_SECONDS = 0.25
"""Of the squeeze and of the release, how long the fingers' target moves [s]."""
LONGEST_WAIT = 2.0
"""So long what was put down may go on moving before it is looked at [s]."""
EMPTY = 0.001
"""Fingers this close to the middle hold nothing [m]."""
BELOW_TABLE = -0.05
"""What is seen at this height has fallen off the table [m]."""
ON_THE_WAY = 0.0
"""Clearance of the arm on its way home, since it may start out close to something [m]."""


class PickAndPlace:
    """Puts one object into or onto another. ``run`` carries it out."""

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str, target: str) -> None:
        self._cell = cell
        self._rng = rng
        self._item = item
        self._target = target
        self._banned: Grasps = []
        self._attempt = 1
        container = cell.physics.bodies[target].opening is not None
        self._wanted = Relation("in" if container else "on", (item, target))

    def run(self) -> Iterator[Stage]:
        """Look, pick, place and check, in up to ``ATTEMPTS`` attempts.

        Raises:
            ActionFailure: it did not succeed; the gripper is open and the arm at home.
        """
        yield from self._go_home()
        for self._attempt in range(1, ATTEMPTS + 1):
            moved = len(self._banned)
            try:
                yield from self._try()
            except ActionFailure as failure:
                yield from self._go_home()
                if self._cell.relations.holds(self._wanted):  # lost over the container
                    return
                nothing_tried = len(self._banned) == moved
                if self._attempt == ATTEMPTS or (nothing_tried and not self._banned):
                    raise
                if nothing_tried:
                    self._banned.clear()
                del failure
            else:
                return

    def _try(self) -> Iterator[Stage]:
        yield self._stage("look")
        clouds, destination = self._look(item=True)
        self._placing().check_room(self._item, destination)
        pick = self._plan(clouds[self._item], destination)
        yield from self._take(pick)
        yield from self._put(pick)
        yield from self._go_home()
        yield from self._check()

    def _look(self, *, item: bool) -> tuple[dict[str, Cloud], Destination]:
        """Clouds of all that is seen, the destination and the item from close up."""
        closely = (self._item, self._target) if item else (self._target,)
        clouds = self._cell.look_at(*closely)
        for name in closely:
            body = self._cell.physics.bodies[name]
            if self._cell.physics.height_of(body) < BELOW_TABLE:
                raise ActionFailure("look", f"{name} has fallen off the table")
            if name not in clouds:
                raise ActionFailure("look", f"{name} is not seen by any camera")
        body = self._cell.physics.bodies[self._target]
        destination = Destination(self._cell.physics, body, clouds, moved=self._item)
        return clouds, destination

    def _plan(self, cloud: Cloud, destination: Destination) -> Pick:
        self._cell.collisions.refresh()
        goal = np.append(destination.centre, destination.rim)
        picking = Picking(self._cell.collisions, self._cell.physics.joints, goal, self._rng)
        return picking.choose(self._item, cloud, self._banned)

    def _take(self, pick: Pick) -> Iterator[Stage]:
        panda = self._cell.panda
        yield from self._during("reach", panda.follow(pick.reach, FREE_SPEED))
        self._banned.append(pick.grasp)
        if pick.opening < LARGEST_OPENING:
            yield from self._during("reach", panda.open(pick.opening, 0.15))
        yield from self._during("approach", panda.trace(pick.approach, CLOSE_SPEED))
        yield from self._during("approach", panda.wait(PAUSE))
        closing = panda.grip(0.0, SQUEEZE_SECONDS, CLOSING_SECONDS)
        yield from self._during("grasp", closing)
        yield from self._during("lift", panda.trace(pick.lift, LIFT_SPEED))
        yield from self._during("lift", panda.wait(PAUSE))
        if not self._held():
            missed = self._cell.physics.opening < EMPTY
            how = "the fingers closed on nothing" if missed else "it slipped"
            raise ActionFailure("lift", f"{'missed' if missed else 'slipped'}: {how}")

    def _put(self, pick: Pick) -> Iterator[Stage]:
        panda = self._cell.panda
        try:
            yield self._stage("carry")
            _, destination = self._look(item=False)
            place = self._placing().choose(self._item, destination)
        except ActionFailure:
            yield from self._put_back(pick)
            raise
        yield from self._during("carry", panda.follow(place.carry, CARRY_SPEED))
        yield from self._during("lower", panda.trace(place.lower, LIFT_SPEED))
        yield from self._during("lower", panda.wait(2 * PAUSE))
        if not self._held():
            raise ActionFailure("carry", f"slipped: {self._item} was lost on the way")
        opening = panda.grip(place.opening, RELEASE_SECONDS, CLOSING_SECONDS)
        yield from self._during("release", opening)
        yield from self._during("retreat", panda.trace(place.lower[::-1], LIFT_SPEED))

    def _put_back(self, pick: Pick) -> Iterator[Stage]:
        """Where it was taken from, since it cannot be put where it should go."""
        panda = self._cell.panda
        yield from self._during("put back", panda.trace(pick.lift[::-1], LIFT_SPEED))
        yield from self._during("put back", panda.open())
        yield from self._during("put back", panda.trace(pick.approach[::-1], LIFT_SPEED))

    def _check(self) -> Iterator[Stage]:
        physics = self._cell.physics
        deadline = physics.time + LONGEST_WAIT
        yield from self._during("check", self._cell.panda.wait(0.25))
        while not physics.resting() and physics.time < deadline:
            yield from self._during("check", self._cell.panda.wait(0.1))
        if not self._cell.relations.holds(self._wanted):
            inside = "in" if self._wanted.name == "in" else "on"
            raise ActionFailure("check", f"{self._item} did not stay {inside} {self._target}")

    def _go_home(self) -> Iterator[Stage]:
        """Open the gripper and bring the arm home, whatever state it was left in."""
        physics, panda = self._cell.physics, self._cell.panda
        if np.abs(physics.joints - HOME).max() > 0.02:
            collisions = self._cell.collisions
            if self._held():
                yield from self._during("release", panda.open())
            collisions.refresh()
            opening = physics.opening
            path = free_path(
                physics.joints,
                HOME,
                lambda q: collisions.find(q, opening, ON_THE_WAY) is not None,
                self._rng,
            )
            straight = np.array([physics.joints, HOME])
            yield from self._during(
                "home", panda.follow(straight if path is None else path, FREE_SPEED)
            )
        if physics.commanded_opening < LARGEST_OPENING:
            yield from self._during("home", panda.open())

    def _placing(self) -> Placing:
        return Placing(self._cell.physics, self._cell.collisions, self._rng)

    def _held(self) -> bool:
        return self._cell.relations.holds(Relation("held", (self._item,)))

    def _stage(self, name: str) -> Stage:
        return Stage(name=name, attempt=self._attempt)

    def _during(self, name: str, motion: Iterator[None]) -> Iterator[Stage]:
        """The same stage at every look-in of a motion."""
        stage = self._stage(name)
        yield stage
        for _ in motion:
            yield stage
