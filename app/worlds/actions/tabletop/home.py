from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.aims import ANYWHERE, At
from app.worlds.actions.displacement import moved_beside, place_of
from app.worlds.actions.manoeuvre import Manoeuvre
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("home")
class Home:
    """Puts down what the gripper holds, on a free place of the table, and brings the arm home."""

    signature = ActionSignature(
        name="home",
        parameters=(),
        meaning="Put what the gripper holds down on the table, and bring the arm home.",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """What was held stands on the table."""
        del arguments  # There are none.
        item = _held(facts)
        return Effects() if item is None else moved_beside(facts, item, place_of(facts, item))

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        del arguments  # There are none.
        item = _held(cell.relations.facts())
        if item is None:
            yield from Manoeuvre(cell, rng, None).come_home()
        else:
            aim = At(cell, item, cell.relations.place(item), ANYWHERE)
            yield from PickAndPlace(cell, rng, item, aim).run()


def _held(facts: frozenset[Relation]) -> str | None:
    return next((fact.arguments[0] for fact in facts if fact.name == "held"), None)
