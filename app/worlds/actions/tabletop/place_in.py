from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.aims import Onto
from app.worlds.actions.displacement import moved_onto
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.preconditions import (
    refuse_circle,
    refuse_itself,
    require_free_gripper,
    require_open,
)
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("place_in")
class PlaceIn:
    """Puts an object into a container."""

    signature = ActionSignature(
        name="place_in",
        parameters=(Parameter(name="obj"), Parameter(name="container", role="container")),
        meaning="Put obj into container, taking it up first unless the gripper holds it.",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """The object is in the other, with what it carries.

        Raises:
            ActionFailure: the other holds nothing or is shut, stands in or on the object, or the gripper
                holds something else.
        """
        item, target = arguments
        _refuse(facts, item, target)
        if Relation("container", (target,)) not in facts:
            raise ActionFailure("check", f"{target} is no container")
        if Relation("in", (item, target)) in facts:
            return Effects()
        return moved_onto(facts, item, target)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, target = arguments
        _refuse(cell.relations.facts(), item, target)
        if cell.physics.bodies[target].opening is None:
            raise ActionFailure("check", f"{target} is no container")
        aim = Onto(cell, item, target, "in")
        if not aim.reached():
            yield from PickAndPlace(cell, rng, item, aim).run()


def _refuse(facts: frozenset[Relation], item: str, target: str) -> None:
    refuse_itself(item, target, "put into")
    refuse_circle(facts, item, target)
    require_open(facts, target)
    require_free_gripper(facts, item)
