from collections.abc import Iterator

import numpy as np

from app.domain.action import ActionSignature, Effects, Parameter
from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.world import Stage
from app.worlds.actions.pick_and_place import PickAndPlace
from app.worlds.actions.tabletop import actions
from app.worlds.simulators.mujoco.workcell import Workcell


@actions.register("grab_and_putin")
class GrabAndPutIn:
    """The paper's one primitive on the tabletop: pick up one object, put it in or on another."""

    signature = ActionSignature(
        name="grab_and_putin",
        parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
        meaning="Pick up obj1 and put it into obj2, or on top of obj2 if it is no container.",
    )

    def effects(self, facts: frozenset[Relation], *arguments: str) -> Effects:
        """What is in or on the object moves with it; where the destination is, it now is as well.

        Raises:
            ActionFailure: the two are the same, or the destination stands in or on the object.
        """
        item, target = arguments
        _refuse(facts, item, target)
        inside = Relation("container", (target,)) in facts
        if Relation("in" if inside else "on", (item, target)) in facts:
            return Effects()
        moved = {item} | {fact.arguments[0] for fact in facts if _rests(fact, upon=item)}
        removes = {fact for fact in facts if _places(fact, moved)}
        adds = {
            Relation(fact.name, (name, *fact.arguments[1:]))
            for fact in facts
            for name in moved
            if fact.arguments[0] == target and fact.name in _PLACING and fact.arguments[1] != name
        } | {
            Relation(fact.name, (fact.arguments[0], name))
            for fact in facts
            for name in moved
            if fact.name in _BESIDE and fact.arguments[1] == target and fact.arguments[0] != name
        }
        for name in moved:
            adds |= _rest(facts, name, target)
            adds |= {Relation("near", pair) for pair in ((name, target), (target, name))}
        adds |= {fact for fact in removes if set(fact.arguments) <= moved}
        return Effects(adds=frozenset(adds), removes=frozenset(removes))

    def perform(self, cell: Workcell, rng: np.random.Generator, *arguments: str) -> Iterator[Stage]:
        item, target = arguments
        _refuse(cell.relations.facts(), item, target)
        inside = cell.physics.bodies[target].opening is not None
        if not cell.relations.holds(Relation("in" if inside else "on", (item, target))):
            yield from PickAndPlace(cell, rng, item, target).run()


_BESIDE = ("left_of", "right_of", "near")
_PLACING = ("in", "on", *_BESIDE)


def _refuse(facts: frozenset[Relation], item: str, target: str) -> None:
    if item == target:
        raise ActionFailure("check", f"{item} cannot be put into itself")
    for name in ("in", "on"):
        if Relation(name, (target, item)) in facts:
            raise ActionFailure("check", f"{target} is {name} {item} itself")


def _rests(fact: Relation, *, upon: str) -> bool:
    return fact.name in ("in", "on") and fact.arguments[1] == upon


def _places(fact: Relation, moved: set[str]) -> bool:
    """Whether the fact says where one of the moved objects is; what they carry is not meant."""
    if fact.name in _BESIDE:
        return bool(moved & set(fact.arguments))
    return fact.name in ("in", "on", "held") and fact.arguments[0] in moved


def _rest(facts: frozenset[Relation], name: str, target: str) -> set[Relation]:
    """How an object rests that was put into or onto the target."""
    inside = Relation("container", (target,)) in facts
    flat = Relation("flat", (target,)) in facts
    rests = {Relation("in", (name, target))} if inside else set()
    return rests | ({Relation("on", (name, target))} if flat or not inside else set())
