"""Primitive: what every verb of the tabletop robot is, in the facts and in physics."""

from collections.abc import Iterator
from typing import Protocol

import numpy as np

from app.domain.action import SymbolicAction
from app.domain.world import Stage
from app.worlds.simulators.mujoco.workcell import Workcell


class TabletopAction(SymbolicAction, Protocol):
    """A verb that can be carried out by the arm as well as in the facts."""

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        """Carry it out; yields at least every 0.2 s of simulated time.

        Args:
            cell: the robot's surroundings.
            rng: the action's own stream of random numbers.
            arguments: names of objects that are in the scene; numbers as text.

        Raises:
            ActionFailure: it did not succeed; the arm is at home; the gripper is open, or holds
                what it held before.
        """
        ...
