from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.preconditions import (
    refuse_circle,
    refuse_itself,
    require_clear,
    require_free_gripper,
)
from app.worlds.actions.tabletop import actions
from app.worlds.actions.wiping_down import WipingDown
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("wipe")
class Wipe:
    """Wipes the top of an object, and puts the sponge or cloth back unless it was held before."""

    signature = ActionSignature(
        name="wipe",
        parameters=(Parameter(name="obj"), Parameter(name="tool")),
        meaning="Wipe the top of obj with tool, a sponge or a cloth, and put tool back.",
        said=r"\b(?:wipe|clean|scrub|polish|dust|mop|rub)\b",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """The object is wiped; both are where they were, be it in the gripper.

        Raises:
            ActionFailure: it cannot be wiped with that, or the gripper holds something else.
        """
        item, tool = arguments
        _refuse(facts, item, tool, wipeable=Relation("level", (item,)) in facts)
        if Relation("container", (tool,)) in facts:
            raise _no_cloth(tool)
        return Effects(adds=frozenset({Relation("wiped", (item,))}))

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, tool = arguments
        physics = cell.physics
        _refuse(cell.relations.facts(), item, tool, wipeable=physics.is_level(item))
        if physics.bodies[tool].opening is not None:
            raise _no_cloth(tool)
        if not cell.relations.holds(Relation("wiped", (item,))):
            yield from WipingDown(cell, rng, tool, item).run()


def _refuse(facts: frozenset[Relation], item: str, tool: str, *, wipeable: bool) -> None:
    refuse_itself(item, tool, "wiped with")
    refuse_circle(facts, tool, item)
    require_free_gripper(facts, tool)
    require_clear(facts, item, tool)
    if not wipeable:
        raise ActionFailure("check", f"{item} has no level top to wipe")


def _no_cloth(tool: str) -> ActionFailure:
    return ActionFailure("check", f"{tool} is a container, nothing to wipe with")
