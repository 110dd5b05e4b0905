"""Displacement: how the facts change when an object comes to stand somewhere else.

Besides the relations, the facts tell where everything stands, as text: ``at(apple, 0.5, 0.2)`` [m].
"""

from app.domain.action import Effects
from app.domain.condition import Relation
from app.worlds.simulators.mujoco.relations import BESIDE

Facts = frozenset[Relation]
Place = tuple[float, float]
"""x and y in the table frame [m]."""
SIDES = ("left_of", "right_of", "in_front_of", "behind")
_PAIRED = (*SIDES, "near")


def place_of(facts: Facts, name: str) -> Place:
    """Where an object stands."""
    for fact in facts:
        if fact.name == "at" and fact.arguments[0] == name:
            return float(fact.arguments[1]), float(fact.arguments[2])
    return 0.0, 0.0


def with_riders(facts: Facts, item: str) -> set[str]:
    """The object, and all that rests in or on it, directly or not."""
    moved = {item}
    while True:
        riders = {
            fact.arguments[0]
            for fact in facts
            if fact.name in ("in", "on") and fact.arguments[1] in moved
        }
        if riders <= moved:
            return moved
        moved |= riders


def lifted(facts: Facts, item: str) -> Effects:
    """The object was taken into the gripper, with what is in or on it."""
    moved = with_riders(facts, item)
    removes = {fact for fact in facts if _tells_place(fact, moved)}
    kept = {fact for fact in removes if set(fact.arguments) <= moved}
    adds = kept | {Relation("held", (item,))}
    return Effects(adds=frozenset(adds), removes=frozenset(removes - kept))


def moved_beside(facts: Facts, item: str, place: Place, near: tuple[str, ...] = ()) -> Effects:
    """The object, with what is in or on it, stands on the table at a place.

    Args:
        facts: before.
        item: what is moved.
        place: where to.
        near: what it is near there.
    """
    return _moved(facts, item, place, set(near))


def moved_onto(facts: Facts, item: str, target: str) -> Effects:
    """The object, with what is in or on it, is in or on the target; where that is, it is as well."""
    near = {
        fact.arguments[1] for fact in facts if fact.name == "near" and fact.arguments[0] == target
    }
    effects = _moved(facts, item, place_of(facts, target), near | {target})
    rests: set[Relation] = set()
    for name in with_riders(facts, item):
        rests |= _rest(facts, name, target, direct=name == item)
        rests |= {
            Relation(fact.name, (name, fact.arguments[1]))
            for fact in facts
            if fact.name in ("in", "on")
            and fact.arguments[0] == target
            and fact.arguments[1] not in (name, item)
            and (fact.name == "in" or Relation("flat", (fact.arguments[1],)) in facts)
        }
    return Effects(adds=effects.adds | rests, removes=effects.removes - rests)


def _moved(facts: Facts, item: str, place: Place, near: set[str]) -> Effects:
    moved = with_riders(facts, item)
    removes = {fact for fact in facts if _tells_place(fact, moved) or _is_at(fact, moved)}
    adds = {
        fact
        for fact in removes
        if fact.name not in ("at", "held", "handed_over") and set(fact.arguments) <= moved
    }
    x, y = (f"{value:.4f}" for value in place)
    adds |= {Relation("at", (name, x, y)) for name in moved}
    others = {fact.arguments[0] for fact in facts if fact.name == "at"} - moved
    for other in others:
        for name in moved:
            adds |= _sides(name, place, other, place_of(facts, other))
    for other in near - moved:
        adds |= {
            Relation("near", pair) for name in moved for pair in ((name, other), (other, name))
        }
    return Effects(adds=frozenset(adds), removes=frozenset(removes))


def _sides(name: str, place: Place, other: str, there: Place) -> set[Relation]:
    """How two objects at two places stand to one another."""
    found: set[Relation] = set()
    forward, left = place[0] - there[0], place[1] - there[1]
    for amount, greater, less in (
        (left, "left_of", "right_of"),
        (forward, "behind", "in_front_of"),
    ):
        if abs(amount) > BESIDE:
            ours, theirs = (greater, less) if amount > 0 else (less, greater)
            found |= {Relation(ours, (name, other)), Relation(theirs, (other, name))}
    return found


def _tells_place(fact: Relation, moved: set[str]) -> bool:
    """Whether the fact says where one of the moved objects is; what they carry is not meant."""
    if fact.name in _PAIRED:
        return bool(moved & set(fact.arguments))
    return fact.name in ("in", "on", "held", "handed_over") and fact.arguments[0] in moved


def _is_at(fact: Relation, moved: set[str]) -> bool:
    return fact.name == "at" and fact.arguments[0] in moved


def _rest(facts: Facts, name: str, target: str, *, direct: bool) -> set[Relation]:
    """How an object rests that was put into or onto the target, or came along in such a one."""
    inside = Relation("container", (target,)) in facts
    flat = Relation("flat", (target,)) in facts
    rests = {Relation("in", (name, target))} if inside else set[Relation]()
    return rests | ({Relation("on", (name, target))} if flat or (direct and not inside) else set())
