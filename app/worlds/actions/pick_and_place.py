"""Pick and place: look, take hold, lift, carry, put down, check; again where it went wrong."""

from collections.abc import Generator, Iterator, Mapping
from typing import Protocol

import numpy as np

from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import (
    CARRY_SPEED,
    CLOSING_SECONDS,
    LIFT_SPEED,
    PAUSE,
    RELEASE_SECONDS,
)
from app.worlds.actions.taking import Taking
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.destination import Destination
from app.worlds.simulators.mujoco.picking import Pick
from app.worlds.simulators.mujoco.placing import Place
from app.worlds.simulators.mujoco.workcell import Workcell

HIGH = 0.05
"""From this height of the hand on, what was put down must be seen again [m]."""


class Aim(Protocol):
    """Where an object is to come to."""

    looked_at: tuple[str, ...]
    """What is to be seen from close up, besides the object."""
    missed: str
    """What went wrong where it was not reached: ``did not stay in bowl``."""

    def reached(self) -> bool:
        """Whether the object is there now."""
        ...

    def room(self, clouds: Mapping[str, Cloud]) -> Destination:
        """The places it may be put down at.

        Raises:
            ActionFailure: there are none.
        """
        ...


class PickAndPlace(Taking):
    """Brings one object to where an aim says. ``run`` carries it out."""

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str, aim: Aim) -> None:
        super().__init__(cell, rng, item)
        self._aim = aim

    def run(self) -> Iterator[Stage]:
        """Look, pick, place and check, in up to ``ATTEMPTS`` attempts.

        An object that is in the gripper already is only put down; where that is not possible, it
        stays there, the arm at home.

        Raises:
            ActionFailure: it did not succeed; the gripper is open and the arm at home.
        """
        if self._held() and (yield from self._put_what_is_held()):
            return
        # What is lost over the container is where it should be.
        yield from self._in_attempts(self._try, self._aim.reached)

    def _put_what_is_held(self) -> Generator[Stage, None, bool]:
        """Put it down; gives whether that was it."""
        try:
            yield self._stage("look")
            yield from self._put()
            yield from self.come_home()
            yield from self._check()
        except ActionFailure:
            if self._held():
                raise
            yield from self.come_home()
            return self._aim.reached()
        return True

    def _try(self) -> Iterator[Stage]:
        yield self._stage("look")
        clouds = self._look_at(self._item, *self._aim.looked_at)
        destination = self._aim.room(clouds)
        self._placing().check_room(self._item, destination)
        pick = self._plan(clouds[self._item], np.append(destination.centre, destination.rim))
        yield from self._take(pick)
        yield from self._put(pick)
        yield from self.come_home()
        yield from self._check()

    def _put(self, pick: Pick | None = None) -> Iterator[Stage]:
        manipulator = self._cell.manipulator
        try:
            yield self._stage("carry")
            place = self._choose_place()
        except ActionFailure:
            if pick is not None:
                yield from self._put_back(pick)
            raise
        yield from self._during("carry", manipulator.follow(place.carry, CARRY_SPEED))
        yield from self._during("lower", manipulator.trace(place.lower, LIFT_SPEED))
        yield from self._during("lower", manipulator.wait(2 * PAUSE))
        if not self._held():
            raise ActionFailure("carry", f"slipped: {self._item} was lost on the way")
        opening = manipulator.grip(place.opening, RELEASE_SECONDS, CLOSING_SECONDS)
        yield from self._during("release", opening)
        yield from self._during("retreat", manipulator.trace(place.lower[::-1], LIFT_SPEED))
        if self._cell.physics.arm.forward(place.lower[-1])[2, 3] > HIGH:
            self._cell.look_at()  # What stands so high now is in the way home.

    def _choose_place(self) -> Place:
        clouds = self._look_at(self._item, *self._aim.looked_at)
        return self._placing().choose(self._item, self._aim.room(clouds))

    def _put_back(self, pick: Pick) -> Iterator[Stage]:
        """Where it was taken from, since it cannot be put where it should go."""
        manipulator = self._cell.manipulator
        yield from self._during("put back", manipulator.trace(pick.lift[::-1], LIFT_SPEED))
        yield from self._during("put back", manipulator.open())
        yield from self._during("put back", manipulator.trace(pick.approach[::-1], LIFT_SPEED))

    def _check(self) -> Iterator[Stage]:
        yield from self._come_to_rest()
        if not self._aim.reached() and not self._reached_from_close_up():
            raise ActionFailure("check", f"{self._item} {self._aim.missed}")

    def _reached_from_close_up(self) -> bool:
        """The same, seen better: what is thin, or low in a container, does not show from afar."""
        self._cell.look_at(self._item, *self._aim.looked_at)
        return self._aim.reached()
