"""Righting up: take an object that lies on its side, turn it up, put it down, check."""

from collections.abc import Iterator

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.manoeuvre import (
    CARRY_SPEED,
    CLOSING_SECONDS,
    LIFT_SPEED,
    RELEASE_SECONDS,
    Array,
)
from app.worlds.actions.taking import Taking
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.picking import Pick
from app.worlds.simulators.mujoco.righting import RELEASE, Righting, up_axis
from app.worlds.simulators.mujoco.table_room import TableRoom

AROUND = 0.16
"""How far from where it lies it may come to stand [m]."""
ASKEW = 0.35
"""The fingers must close across the object: the cosine of their angle with its axis, at most."""
TRIES = 12
"""So many grasps are turned down before it is given up."""


class RightingUp(Taking):
    """Puts one object upright. ``run`` carries it out."""

    def run(self) -> Iterator[Stage]:
        """Take it, turn it and put it down, in up to ``ATTEMPTS`` attempts.

        Raises:
            ActionFailure: it did not succeed; the gripper is open and the arm at home.
        """
        yield from self._in_attempts(self._try, self._stands)

    def _try(self) -> Iterator[Stage]:
        yield self._stage("look")
        cloud = self._look_at(self._item)[self._item]
        pick = self._plan_across(cloud)
        yield from self._take(pick)
        cell, manipulator = self._cell, self._cell.manipulator
        yield self._stage("carry")
        clouds = self._look_at(self._item)
        middle = ((cloud.lowest + cloud.highest) / 2)[:2]
        distance = float(np.linalg.norm(middle))
        wish = middle * (np.clip(distance, 0.38, 0.60) / distance)
        room = TableRoom(clouds, self._item, wish, AROUND)
        way = Righting(cell.physics, cell.collisions, self._rng).choose(self._item, room)
        yield from self._during("carry", manipulator.follow(way.carry, CARRY_SPEED))
        yield from self._during("lower", manipulator.trace(way.lower, LIFT_SPEED))
        yield from self._during(
            "release", manipulator.grip(RELEASE, RELEASE_SECONDS, CLOSING_SECONDS)
        )
        yield from self._during("retreat", manipulator.trace(way.back, LIFT_SPEED))
        yield from self.come_home()
        yield from self._come_to_rest()
        if not self._stands():
            raise ActionFailure("check", f"{self._item} does not stand upright")

    def _plan_across(self, cloud: Cloud) -> Pick:
        """A pick whose fingers close across the object's axis, so that it can be turned up."""
        axis = up_axis(self._cell.physics, self._item)
        here: Array = np.append((cloud.lowest + cloud.highest)[:2] / 2, cloud.lowest[2])
        earlier = list(self._banned)
        try:
            for _ in range(TRIES):
                pick = self._plan(cloud, here)
                if abs(float(pick.grasp.tool[:3, 1] @ axis)) < ASKEW:
                    return pick
                self._banned.append(pick.grasp)
        finally:
            self._banned = earlier
        raise ActionFailure("grasp", f"no grasp of {self._item} was found to turn it up by")

    def _stands(self) -> bool:
        relations = self._cell.relations
        upright = relations.holds(Relation("upright", (self._item,)))
        return upright and relations.on_table(self._item)
