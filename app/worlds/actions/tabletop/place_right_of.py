from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.beside import BESIDE, effects_beside, perform_beside
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("place_right_of")
class PlaceRightOf:
    """Puts an object on the table to the right of another, as the robot sees it."""

    signature = ActionSignature(
        name="place_right_of",
        parameters=(Parameter(name="obj"), Parameter(name="reference", role="support")),
        meaning="Put obj on the table to the right of reference, as the robot sees it.",
        said=rf"\bright(?:[- ]hand)?(?: side)? of\b|{BESIDE}",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """It stands there, near the reference; see ``effects_beside``."""
        item, reference = arguments
        return effects_beside(facts, item, "right_of", reference)

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, reference = arguments
        yield from perform_beside(cell, rng, item, "right_of", reference)
