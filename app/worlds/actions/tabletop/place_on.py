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
)
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("place_on")
class PlaceOn:
    """Puts an object onto another, or on a flat container such as a plate."""

    signature = ActionSignature(
        name="place_on",
        parameters=(Parameter(name="obj"), Parameter(name="support", role="support")),
        meaning="Put obj on top of support, taking it up first unless the gripper holds it.",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """The object is on the other, with what it carries.

        Raises:
            ActionFailure: the other takes things only inside, stands in or on the object, or the gripper
                holds something else.
        """
        item, target = arguments
        _refuse(facts, item, target)
        if Relation("container", (target,)) in facts and Relation("flat", (target,)) not in facts:
            raise ActionFailure("check", f"things are put into {target}, not on it")
        if Relation("on", (item, target)) in facts:
            return Effects()
        return moved_onto(facts, item, target)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, target = arguments
        _refuse(cell.relations.facts(), item, target)
        opening = cell.physics.bodies[target].opening
        if opening is not None and not opening.flat:
            raise ActionFailure("check", f"things are put into {target}, not on it")
        aim = Onto(cell, item, target, "on")
        if not aim.reached():
            yield from PickAndPlace(cell, rng, item, aim).run()


def _refuse(facts: frozenset[Relation], item: str, target: str) -> None:
    refuse_itself(item, target, "put onto")
    refuse_circle(facts, item, target)
    require_free_gripper(facts, item)
