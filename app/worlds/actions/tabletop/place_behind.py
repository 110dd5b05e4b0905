from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.beside import BESIDE, effects_beside, perform_beside
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("place_behind")
class PlaceBehind:
    """Puts an object on the table behind another, on its side away from the robot."""

    signature = ActionSignature(
        name="place_behind",
        parameters=(Parameter(name="obj"), Parameter(name="reference", role="support")),
        meaning="Put obj on the table behind reference, on its side away from the robot.",
        said=rf"\bbehind\b|{BESIDE}",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands there, near the reference; see ``effects_beside``."""
        item, reference = arguments
        return effects_beside(facts, item, "behind", reference)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, reference = arguments
        yield from perform_beside(cell, rng, item, "behind", reference)
