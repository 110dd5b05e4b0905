from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
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


@actions.register("grab_and_putin")
class GrabAndPutIn:
    """The paper's one primitive on the tabletop: pick up one object, put it in or on another."""

    signature = ActionSignature(
        name="grab_and_putin",
        parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="support")),
        meaning="Pick up obj1 and put it into obj2, or on top of obj2 if it is no container.",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """What is in or on the object moves with it; where the destination is, it now is as well.

        Raises:
            ActionFailure: the two are the same, the destination stands in or on the object or is
                shut, or the gripper holds something else.
        """
        item, target = arguments
        _refuse(facts, item, target)
        inside = Relation("container", (target,)) in facts
        if Relation("in" if inside else "on", (item, target)) in facts:
            return Effects()
        return moved_onto(facts, item, target)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, target = arguments
        _refuse(cell.relations.facts(), item, target)
        aim = Onto(cell, item, target)
        if not aim.reached():
            yield from PickAndPlace(cell, rng, item, aim).run()


def _refuse(facts: frozenset[Relation], item: str, target: str) -> None:
    refuse_itself(item, target, "put into")
    refuse_circle(facts, item, target)
    require_open(facts, target)
    require_free_gripper(facts, item)
