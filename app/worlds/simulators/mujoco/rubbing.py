"""Rubbing: how much of each object's level top something in the gripper was drawn over.

What was rubbed is kept in the simulator's own user data, so that it is saved and restored with the
rest of the state.
"""

from collections.abc import Mapping

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.level_top import GROUPS, LevelTop, level_top
from app.worlds.simulators.mujoco.scene_builder import CELLS, ObjectBody

Array = NDArray[np.float64]

EVERY = 20
"""So many time steps lie between two observations."""
SMALLEST = 0.0012
"""A level top of a smaller area is none [m²]."""
PASSING = 0.003
"""A cell is rubbed by what passes over it no farther up than this [m]."""
SLOWEST = 0.005
"""What moves over the top more slowly than this only lies there [m/s]."""


class Rubbing:
    """Watches what the gripper holds touch other objects, and remembers where it went."""

    def __init__(
        self, model: mujoco.MjModel, bodies: Mapping[str, ObjectBody], fingers: tuple[int, ...]
    ) -> None:
        """Prepare.

        Args:
            model: with room for every object's cells in its user data.
            bodies: the objects, in the order of the scene.
            fingers: the bodies whose touch holds an object.
        """
        self._model = model
        self._bodies = bodies
        self._fingers = set(fingers)
        self._names = {part: name for name, body in bodies.items() for part in body.parts}
        self._is_object = np.isin(np.arange(model.nbody), list(self._names))
        self._index = {name: index for index, name in enumerate(bodies)}
        self._tops: dict[str, LevelTop] = {}

    def top(self, name: str) -> LevelTop:
        """The level top of an object."""
        if name not in self._tops:
            self._tops[name] = level_top(self._model, self._bodies[name])
        return self._tops[name]

    def is_level(self, name: str) -> bool:
        """Whether a tool gets to a level top of some size: not to the floor of what is hollow."""
        body = self._bodies[name]
        hollow = body.opening is not None and not body.opening.flat
        return not hollow and self.top(name).area >= SMALLEST

    def share(self, data: mujoco.MjData, name: str) -> float:
        """The share of an object's level top that was rubbed so far, in [0, 1]."""
        rubbed = self._rubbed(data, name)[self.top(name).cells]
        return float(rubbed.mean()) if len(rubbed) else 0.0

    def observe(self, data: mujoco.MjData) -> None:
        """Mark what is being rubbed now."""
        pairs = self._model.geom_bodyid[data.contact.geom[: data.ncon]]  # (k, 2)
        if not self._is_object[pairs].all(axis=1).any():
            return  # No object touches another, as is the case most of the time.
        touching = {(a, b) for pair in pairs.tolist() for a, b in (pair, pair[::-1])}
        touched = {(self._name(first), second) for first, second in touching}
        held = [n for n in self._bodies if all((n, finger) in touched for finger in self._fingers)]
        for tool in held:
            under = {self._name(second) for name, second in touched if name == tool}
            for name in under - {None, tool}:
                if name is not None:
                    self._rub(data, self._bodies[tool], self._bodies[name])

    def _name(self, body: int) -> str | None:
        return self._names.get(body)

    def _rub(self, data: mujoco.MjData, tool: ObjectBody, surface: ObjectBody) -> None:
        """Mark what of a top lies under a tool that moves over it."""
        drawn = data.qvel[tool.dof_address :][:2] - data.qvel[surface.dof_address :][:2]
        if np.hypot(*drawn) < SLOWEST:
            return
        top, rubbed = self.top(surface.name), self._rubbed(data, surface.name)
        rotation = data.xmat[surface.body_id].reshape(3, 3)
        middles = data.xpos[surface.body_id] + top.middles @ rotation.T
        away = np.linalg.norm(middles - data.xpos[tool.body_id], axis=1)
        near = away < tool.footprint_radius + tool.height
        for index in np.flatnonzero(near & (rubbed[top.cells] == 0)):
            if self._passes(data, middles[index], rotation[:, 2], tool, surface):
                rubbed[top.cells[index]] = 1.0

    def _passes(
        self, data: mujoco.MjData, place: Array, up: Array, tool: ObjectBody, surface: ObjectBody
    ) -> bool:
        """Whether a tool's underside is at most ``PASSING`` over a place, shape (3,) [m]."""
        met = np.zeros(1, np.int32)
        start = place - PASSING * up  # It may be pressed in a little.
        distance = mujoco.mj_ray(self._model, data, start, up, GROUPS, False, surface.body_id, met)
        hit = met[0] >= 0 and distance < 2 * PASSING
        return bool(hit) and int(self._model.geom_bodyid[met[0]]) in tool.parts

    def _rubbed(self, data: mujoco.MjData, name: str) -> Array:
        """A view of an object's cells in the user data, shape (CELLS,); 1 where it was rubbed."""
        start = CELLS * self._index[name]
        return data.userdata[start : start + CELLS]
