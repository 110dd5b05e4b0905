from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.beside import BESIDE, effects_beside, perform_beside
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("place_in_front_of")
class PlaceInFrontOf:
    """Puts an object on the table in front of another, on the robot's side of it."""

    signature = ActionSignature(
        name="place_in_front_of",
        parameters=(Parameter(name="obj"), Parameter(name="reference", role="support")),
        meaning="Put obj on the table in front of reference, on the robot's side of it.",
        said=rf"\bin front of\b|{BESIDE}",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands there, near the reference; see ``effects_beside``."""
        item, reference = arguments
        return effects_beside(facts, item, "in_front_of", reference)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, reference = arguments
        yield from perform_beside(cell, rng, item, "in_front_of", reference)
