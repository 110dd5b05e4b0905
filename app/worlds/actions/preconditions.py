"""Preconditions: what the facts must allow before an action begins, the same in every executor."""

import math

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.program import ActionCall
from app.worlds.simulators.mujoco.placement import REACH, SECTOR

Facts = frozenset[Relation]


def refuse_itself(item: str, other: str, doing: str) -> None:
    """Nothing can be done with an object and itself.

    Raises:
        ActionFailure: both are the same.
    """
    if item == other:
        raise ActionFailure("check", f"{item} cannot be {doing} itself")


def refuse_circle(facts: Facts, item: str, target: str) -> None:
    """What carries the target cannot be put into or onto it.

    Raises:
        ActionFailure: the target stands in or on the object.
    """
    for name in ("in", "on"):
        if Relation(name, (target, item)) in facts:
            raise ActionFailure("check", f"{target} is {name} {item} itself")


def require_free_gripper(facts: Facts, item: str | None = None) -> None:
    """The gripper holds nothing, or the object that is to be worked with.

    Raises:
        ActionFailure: it holds something else; going home puts that down.
    """
    for fact in facts:
        if fact.name == "held" and fact.arguments != (item,):
            reason = f"the gripper holds {fact.arguments[0]}; put it down first"
            raise ActionFailure("check", reason, remedy=(ActionCall(action="home"),))


def require_open(facts: Facts, container: str) -> None:
    """What is shut takes nothing.

    Raises:
        ActionFailure: the container is closed; opening it would help.
    """
    if Relation("closed", (container,)) in facts:
        remedy = ActionCall(action="open", arguments=(container,))
        raise ActionFailure("check", f"{container} is closed; open it first", remedy=(remedy,))


def require_clear(facts: Facts, support: str, item: str) -> None:
    """Nothing but the object itself stands on the support.

    Raises:
        ActionFailure: something else does.
    """
    for fact in sorted(facts, key=str):
        if fact.name == "on" and fact.arguments[1] == support and fact.arguments[0] != item:
            raise ActionFailure("check", f"{fact.arguments[0]} is on {support}; take it off first")


def require_reach(x: float, y: float) -> None:
    """A place on the table is one the arm gets to.

    Args:
        x: ahead of the robot [m].
        y: to its left [m].

    Raises:
        ActionFailure: it is not.
    """
    near, far = REACH
    distance = math.hypot(x, y)
    if not near <= distance <= far or abs(math.atan2(y, x)) > SECTOR:
        reason = (
            f"{x:.2f}, {y:.2f} is out of reach; the arm reaches {near:.2f} to {far:.2f} m from its "
            f"base, up to {math.degrees(SECTOR):.0f} degrees to either side"
        )
        raise ActionFailure("unreachable", reason)


def require_shutting(shuts: bool, item: str) -> None:
    """The object has a drawer, a door or a lid.

    Raises:
        ActionFailure: it has none.
    """
    if not shuts:
        raise ActionFailure("check", f"{item} has no drawer, door or lid")
