"""Beliefs: what the robot takes to be true of the objects, from what its cameras see.

``in``, ``on``, ``held``, ``left_of``, ``right_of`` and ``near`` are decided by clouds and by how far
the fingers are apart. Everything else, a hinge or an upright stand, is asked of the simulator.
"""

from collections.abc import Callable, Mapping
from itertools import permutations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cameras import FEWEST, Cameras
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.outline import Outline, SeenOutlines
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.relations import BESIDE, HEAP, NEAR, Relations
from app.worlds.simulators.mujoco.relief import SUNK

Array = NDArray[np.float64]
Clouds = Mapping[str, Cloud]

EMPTY = 0.0012
"""Fingers this close to the middle hold nothing [m]."""
PRESSING = 0.0008
"""Fingers that stay so far outside of where they are told to go press on something [m]."""
GRASP = 0.045
"""So close to the tool a held object shows some of its points [m]."""
RESTING = 0.012
"""So far apart, up or down, what rests on another may seem to be from it [m]."""
UNDERSIDE = 0.5
"""From above, the underside of what is round is not seen: this share of what is seen."""
AROUND = 0.02
"""So far around an object its support is looked for [m]."""


class Beliefs:
    """What is true as far as the robot can tell."""

    def __init__(self, physics: Physics, cameras: Cameras, truth: Relations) -> None:
        self._physics = physics
        self._cameras = cameras
        self._truth = truth
        self._outlines = SeenOutlines()

    def holds(self, relation: Relation) -> bool:
        """Whether the relation seems to be true now; see ``Relations.holds`` for their meaning."""
        if relation.name == "held":
            return set(relation.arguments) <= self.held()
        decide = _DECIDE.get(relation.name)
        if decide is None:
            return self._truth.holds(relation)
        clouds = self._cameras.current()
        if not all(name in clouds for name in relation.arguments):
            return False
        if relation.name in ("in", "on") and relation.arguments[0] in self.held():
            return False
        return decide(self, clouds, *relation.arguments)

    def facts(self) -> frozenset[Relation]:
        """Every ``in``, ``on`` and ``held`` that seems to be true now."""
        clouds = self._cameras.current()
        held = self.held()
        pairs = permutations([name for name in clouds if name not in held], 2)
        found = [
            Relation(name, pair)
            for pair in pairs
            for name in ("in", "on")
            if _DECIDE[name](self, clouds, *pair)
        ]
        found += [Relation("held", (name,)) for name in held]
        return frozenset(found) | self._truth.shutting()

    def place(self, name: str) -> Array:
        """What counts as an object's middle, shape (2,) [m]."""
        cloud = self._cloud(name)
        return ((cloud.lowest + cloud.highest) / 2)[:2]

    def extent(self, name: str) -> Array:
        """Half the width of an object along x and along y as it stands now, shape (2,) [m]."""
        cloud = self._cloud(name)
        return ((cloud.highest - cloud.lowest) / 2)[:2]

    def on_table(self, name: str) -> bool:
        """Whether an object reaches down to the table and nothing holds it."""
        clouds = self._cameras.current()
        if name not in clouds or name in self.held():
            return False
        return abs(float(clouds[name].lowest[2])) < RESTING + _unseen(clouds[name])

    def _cloud(self, name: str) -> Cloud:
        clouds = self._cameras.current()
        if name not in clouds:  # too thin for a look from afar
            clouds = self._cameras.look(name)
        if name not in clouds:
            raise ActionFailure(
                "look", f"{name} is hidden or has fallen off the table: no camera sees it"
            )
        return clouds[name]

    def held(self) -> frozenset[str]:
        """What shows between the fingers while they press on something."""
        opening = self._physics.opening
        pressing = opening - self._physics.commanded_opening > PRESSING
        if opening < EMPTY or not pressing:
            return frozenset()
        tool = self._physics.arm.forward(self._physics.joints)[:3, 3]
        seen = self._cameras.glimpse(tool, GRASP)
        near = {
            name: np.linalg.norm(cloud.points - tool, axis=1) < GRASP
            for name, cloud in seen.items()
        }
        return frozenset(name for name, close in near.items() if close.any())

    def _in(self, clouds: Clouds, item: str, container: str) -> bool:
        body = self._physics.bodies[container]
        if body.articulation is not None:  # known by its model
            return self._truth.holds(Relation("in", (item, container)))
        if body.opening is None:
            return False
        try:
            outline = self._outlines.of(body, clouds)
        except ActionFailure:  # it lies on its side
            return False
        low, high = clouds[item].lowest, clouds[item].highest
        if float(outline.inset((low[:2] + high[:2]) / 2)) <= 0:
            return False
        inset = outline.inset(clouds[item].points[:, :2])
        if (clouds[item].points[inset < -RESTING, 2] < RESTING).sum() >= FEWEST:
            return False  # it leans on the container from the table
        # Its underside may be hidden; what does not reach out over the rim cannot lie across it.
        inside = float(np.quantile(inset, 0.02)) > 0
        if body.opening.flat or inside or float(low[2]) < outline.rim - SUNK:
            return float(low[2]) < outline.rim + HEAP or body.opening.flat
        return float(low[2]) < outline.rim + HEAP and self._on_contents(
            clouds, item, container, outline
        )

    def _on_contents(self, clouds: Clouds, item: str, container: str, outline: Outline) -> bool:
        """Whether something else in the outline is high enough to bear the item."""
        bottom = float(clouds[item].lowest[2])
        for name in clouds.keys() - {item, container}:
            low, high = clouds[name].lowest, clouds[name].highest
            inside = bool(outline.roomy((low[:2] + high[:2]) / 2)) and low[2] < outline.rim - SUNK
            if inside and abs(float(high[2]) - bottom) < RESTING:
                return True
        return False

    def _on(self, clouds: Clouds, item: str, support: str) -> bool:
        opening = self._physics.bodies[support].opening
        if opening is not None:
            return opening.flat and self._in(clouds, item, support)
        low, high = clouds[item].lowest, clouds[item].highest
        middle, points = (low[:2] + high[:2]) / 2, clouds[support].points
        over = (middle > points[:, :2].min(axis=0)) & (middle < points[:, :2].max(axis=0))
        # What lies right under it is hidden: the support is seen around it.
        around = (points[:, :2] > low[:2] - AROUND) & (points[:, :2] < high[:2] + AROUND)
        top = points[around.all(axis=1), 2].max(initial=-np.inf)
        return bool(over.all()) and -RESTING - _unseen(clouds[item]) < float(top - low[2]) < RESTING

    def _left_of(self, clouds: Clouds, item: str, other: str) -> bool:
        return _middle(clouds[item]) - _middle(clouds[other]) > BESIDE

    def _right_of(self, clouds: Clouds, item: str, other: str) -> bool:
        return self._left_of(clouds, other, item)

    def _near(self, clouds: Clouds, item: str, other: str) -> bool:
        if item == other:
            return False
        distances, _ = KDTree(clouds[item].points).query(clouds[other].points)
        return float(np.min(distances)) < NEAR


def _unseen(cloud: Cloud) -> float:
    """How far below its lowest seen point an object may reach, being round below [m]."""
    return UNDERSIDE * float(cloud.highest[2] - cloud.lowest[2])


def _middle(cloud: Cloud) -> float:
    """How far to the robot's left the middle is [m]."""
    return float(cloud.lowest[1] + cloud.highest[1]) / 2


_DECIDE: dict[str, Callable[..., bool]] = {
    name: getattr(Beliefs, f"_{name}") for name in ("in", "on", "left_of", "right_of", "near")
}
