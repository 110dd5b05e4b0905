from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.aims import Atop
from app.worlds.actions.displacement import moved_onto
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.preconditions import (
    refuse_circle,
    refuse_itself,
    require_clear,
    require_free_gripper,
)
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("stack")
class Stack:
    """Puts an object onto the middle of another's top, their edges aligned."""

    signature = ActionSignature(
        name="stack",
        parameters=(Parameter(name="obj"), Parameter(name="support", role="support")),
        meaning="Put obj onto the middle of support's top, to build a tower.",
        said=r"\b(?:stack|pile|tower)\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It is on the support, with what it carries.

        Raises:
            ActionFailure: the two are the same, the support stands in or on the object or is taken, or
                the gripper holds something else.
        """
        item, support = arguments
        _refuse(facts, item, support)
        if Relation("on", (item, support)) in facts:
            return Effects()
        return moved_onto(facts, item, support)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, support = arguments
        _refuse(cell.relations.facts(), item, support)
        aim = Atop(cell, item, support)
        if not aim.reached():
            yield from PickAndPlace(cell, rng, item, aim).run()


def _refuse(facts: frozenset[Relation], item: str, support: str) -> None:
    refuse_itself(item, support, "stacked on")
    refuse_circle(facts, item, support)
    require_clear(facts, support, item)
    require_free_gripper(facts, item)
