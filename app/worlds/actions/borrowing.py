"""Borrowing: take an object, do something with it, and put it back where it stood."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import Generic, TypeVar

import numpy as np

from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import FREE_SPEED, LIFT_SPEED
from app.worlds.actions.taking import Taking
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.picking import Pick
from app.worlds.simulators.mujoco.workcell import Workcell

Way = TypeVar("Way")
"""How it is done, chosen before the arm moves with what it holds."""


class Borrowing(Taking, ABC, Generic[Way]):
    """Does something to a target with another object. ``run`` carries it out."""

    def __init__(self, cell: Workcell, rng: np.random.Generator, item: str, target: str) -> None:
        super().__init__(cell, rng, item)
        self._target = target

    @abstractmethod
    def _way(self, goal: Cloud) -> Way:
        """How to do it with what is held to the target as it was seen.

        Raises:
            ActionFailure: it cannot be done.
        """
        ...

    @abstractmethod
    def _use(self, way: Way) -> Iterator[Stage]:
        """Do it, and come back to where the arm was before.

        Raises:
            ActionFailure: it was lost; or it did not go well, and the arm is back with it.
        """
        ...

    @abstractmethod
    def _check_done(self) -> None:
        """See what came of it.

        Raises:
            ActionFailure: it was not done.
        """
        ...

    def _check_returned(self) -> None:
        """See that what was put back is as it was; nothing to see to, unless said otherwise."""

    def run(self) -> Iterator[Stage]:
        """In up to ``ATTEMPTS`` attempts; what is in the gripper already stays there.

        Raises:
            ActionFailure: it did not succeed; the arm is at home, the gripper open unless it still
                holds what it held before.
        """
        if self._held():
            yield from self._use_what_is_held()
            return
        yield from self._in_attempts(self._try)

    def _use_what_is_held(self) -> Iterator[Stage]:
        yield self._stage("look")
        yield from self._use(self._way(self._look_at(self._target)[self._target]))
        self._check_done()

    def _try(self) -> Iterator[Stage]:
        yield self._stage("look")
        clouds = self._look_at(self._item, self._target)
        cloud = clouds[self._item]
        here = np.append((cloud.lowest + cloud.highest)[:2] / 2, cloud.lowest[2])
        pick = self._plan(cloud, here)
        yield from self._take(pick)
        try:
            yield from self._use(self._way(clouds[self._target]))
        except ActionFailure:
            if self._held():
                yield from self._put_back(pick)
            raise
        yield from self._put_back(pick)
        yield from self.come_home()
        yield from self._come_to_rest()
        self._check_done()
        self._check_returned()

    def _put_back(self, pick: Pick) -> Iterator[Stage]:
        manipulator = self._cell.manipulator
        yield from self._during("put back", manipulator.trace(pick.lift[::-1], LIFT_SPEED))
        yield from self._during("release", manipulator.open())
        yield from self._during("retreat", manipulator.trace(pick.approach[::-1], FREE_SPEED))
        self._cell.look_at()  # It was last seen in the hand, and stands in the way home now.
