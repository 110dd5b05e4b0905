"""Beside: what the four verbs have in common that put an object on one side of another."""

from collections.abc import Iterator

import numpy as np

from app.domain.action import Effects
from app.domain.condition import Relation
from app.domain.world import Stage
from app.worlds.actions.aims import TOWARDS, Beside
from app.worlds.actions.displacement import moved_beside, place_of
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.preconditions import refuse_circle, refuse_itself, require_free_gripper
from app.worlds.simulators.mujoco.workcell import Workcell

APART = 0.12
"""How far apart the middles of two objects are supposed to be, one put beside the other [m]."""

BESIDE = r"\b(?:next to|beside|alongside|close to|near)\b"
"""What people say of any of the four sides."""


def effects_beside(facts: frozenset[Relation], item: str, side: str, reference: str) -> Effects:
    """The object stands on the table on that side of the reference and near it.

    Raises:
        ActionFailure: the two are the same, the reference stands in or on the object, or the gripper
            holds something else.
    """
    _refuse(facts, item, reference)
    x, y = place_of(facts, reference) + APART * TOWARDS[side]
    return moved_beside(facts, item, (float(x), float(y)), near=(reference,))


def perform_beside(
    cell: Workcell, rng: np.random.Generator, item: str, side: str, reference: str
) -> Iterator[Stage]:
    """Put it there.

    Raises:
        ActionFailure: as for its effects, or it did not succeed.
    """
    _refuse(cell.relations.facts(), item, reference)
    aim = Beside(cell, item, side, reference)
    if not aim.reached():
        yield from PickAndPlace(cell, rng, item, aim).run()


def _refuse(facts: frozenset[Relation], item: str, reference: str) -> None:
    refuse_itself(item, reference, "put beside")
    refuse_circle(facts, item, reference)
    require_free_gripper(facts, item)
