"""Aims: where an object is to come to: into or onto another, beside it, or to a place."""

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from app.domain.condition import Relation
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.destination import Destination
from app.worlds.simulators.mujoco.outline import KnownOutlines
from app.worlds.simulators.mujoco.relations import ACROSS, BESIDE
from app.worlds.simulators.mujoco.table_room import TableRoom, TopMiddle
from app.worlds.simulators.mujoco.workcell import Workcell

Array = NDArray[np.float64]

TOWARDS = {
    "left_of": np.array([0.0, 1.0]),
    "right_of": np.array([0.0, -1.0]),
    "in_front_of": np.array([-1.0, 0.0]),
    "behind": np.array([1.0, 0.0]),
}
"""The side of a reference as a unit vector: x away from the robot, y to its left."""
GAP = 0.035
"""What should be left between an object and the one it is put beside [m]."""
AWAY = 0.10
"""So far from the best place beside it, an object may be put where others are in the way [m]."""
ACCURACY = 0.03
"""An object put at a place may stand so far from it [m]."""
NEXT_TO = 0.012
"""Where something is in the way, a place so near the one asked for will do [m]."""
FARTHEST = 0.72
"""From the robot's base, what the stretched arm still puts down from above [m]."""
ANYWHERE = 0.25
"""How far from the arm's hand something is put down that has no place of its own [m]."""


class Onto:
    """Into a container, or onto what is none, wherever there is room."""

    def __init__(self, cell: Workcell, item: str, target: str, relation: str | None = None) -> None:
        self._cell, self._item, self._target = cell, item, target
        container = cell.physics.bodies[target].opening is not None
        name = relation or ("in" if container else "on")
        self._wanted = Relation(name, (item, target))
        self.looked_at = (target,)
        self.missed = f"did not stay {name} {target}"

    def reached(self) -> bool:
        """Whether it is in or on it."""
        return self._cell.relations.holds(self._wanted)

    def room(self, clouds: Mapping[str, Cloud]) -> Destination:
        """The room inside or on top."""
        body = self._cell.physics.bodies[self._target]
        # What has a moving part is known by its model; a drawer is no hollow in its chest's top.
        known = body.articulation is not None
        outlines = KnownOutlines(self._cell.physics) if known else self._cell.outlines
        return Destination(outlines, body, clouds, moved=self._item)


class Atop(Onto):
    """Onto the middle of another's top."""

    def __init__(self, cell: Workcell, item: str, target: str) -> None:
        super().__init__(cell, item, target, "on")

    def room(self, clouds: Mapping[str, Cloud]) -> Destination:
        """The middle of the top."""
        body = self._cell.physics.bodies[self._target]
        return TopMiddle(self._cell.outlines, body, clouds, moved=self._item)


class Beside:
    """On the table, on one side of another and near it."""

    def __init__(self, cell: Workcell, item: str, side: str, reference: str) -> None:
        self._cell, self._item, self._reference = cell, item, reference
        self._towards = TOWARDS[side]
        self._wanted = [Relation(name, (item, reference)) for name in (side, "near")]
        self.looked_at = (reference,)
        self.missed = f"did not stay {side.replace('_', ' ')} {reference} and near it"

    def reached(self) -> bool:
        """Whether it stands there, on the table."""
        relations = self._cell.relations
        return relations.on_table(self._item) and all(map(relations.holds, self._wanted))

    def room(self, clouds: Mapping[str, Cloud]) -> Destination:
        """Free places on that side, the one straight beside it first."""
        relations = self._cell.relations
        cloud = clouds[self._reference]
        there = relations.place(self._reference)
        middle = ((cloud.lowest + cloud.highest) / 2)[:2]
        span = (cloud.highest - cloud.lowest)[:2] / 2 + relations.extent(self._item)
        wish = middle + self._towards * (float(np.abs(self._towards) @ span) + GAP)
        sideways = self._towards[::-1]

        def allowed(places: Array) -> NDArray[np.bool_]:
            along, across = (places - there) @ self._towards, (places - there) @ sideways
            return (along > BESIDE + 0.015) & (np.abs(across) < along)

        return TableRoom(clouds, self._item, wish, AWAY, allowed)


class At:
    """A place on the table."""

    def __init__(self, cell: Workcell, item: str, place: Array, within: float = NEXT_TO) -> None:
        """Describe it.

        Args:
            cell: the robot's surroundings.
            item: what is to be put there.
            place: shape (2,), base frame [m].
            within: how far from there will do, where something stands in the way [m].
        """
        self._cell, self._item, self._place, self._within = cell, item, place, within
        self.looked_at = ()
        self.missed = f"did not stay at {place[0]:.2f}, {place[1]:.2f}"

    def reached(self) -> bool:
        """Whether its middle is there, on the table."""
        away = np.linalg.norm(self._cell.relations.place(self._item) - self._place)
        near = bool(away <= self._within + ACCURACY)
        return near and self._cell.relations.on_table(self._item)

    def room(self, clouds: Mapping[str, Cloud]) -> Destination:
        """That place, or one next to it."""
        return TableRoom(clouds, self._item, self._place, self._within)


class Across:
    """On the far strip of the table, before the person who sits across from the robot."""

    WISH: ClassVar[tuple[float, float]] = (ACROSS + 0.015, 0.0)
    """Straight ahead, well on the strip; farther out the arm would be stretched [m]."""

    def __init__(self, cell: Workcell, item: str) -> None:
        self._cell, self._item = cell, item
        self.looked_at = ()
        self.missed = "did not stay within the person's reach"

    def reached(self) -> bool:
        """Whether it stands there and nothing holds it."""
        relations = self._cell.relations
        ahead = float(relations.place(self._item)[0]) > ACROSS
        return ahead and relations.on_table(self._item)

    def room(self, clouds: Mapping[str, Cloud]) -> Destination:
        """Free places on that strip, the one straight ahead first."""

        def allowed(places: Array) -> NDArray[np.bool_]:
            return places[..., 0] > ACROSS + 0.010

        return TableRoom(clouds, self._item, np.array(self.WISH), ANYWHERE, allowed, FARTHEST)
