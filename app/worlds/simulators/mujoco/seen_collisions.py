"""Collision checks that know of the objects only what the cameras have seen."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.arm import Arm
from app.worlds.simulators.mujoco.cameras import Cameras
from app.worlds.simulators.mujoco.cloud import Cloud
from app.worlds.simulators.mujoco.collision import Collision, Collisions
from app.worlds.simulators.mujoco.height_map import CELL, CORNER, COUNT, HeightMap
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picking import CLEARANCE
from app.worlds.simulators.mujoco.scene_builder import furnished

Array = NDArray[np.float64]

THINNED = 300
"""So many points stand for an object close to the gripper [-]."""
OVERLAP = 0.004
"""How deep the points of what is put down may be in what was seen, both being uncertain [m]."""
PASSING = 0.012
"""On its way, what is carried stays so far above what was seen; it hangs lower than it looked [m]."""
SKIN = 0.001
"""How deep points may be in the gripper [m]."""
STRAY = 3
"""Fewer points than this are taken for noise."""
FOOT = 0.6
"""What is not seen of an object's underside is taken to be its outline, so much smaller."""
HIGHEST = 1.0
"""Nothing on the table stands higher [m]."""
LOWEST = 0.01
"""The height field's top, where nothing stands on the table [m]."""


class SeenCollisions(Collisions):
    """Checks of the arm against a height map of all clouds, and of points against the gripper."""

    def __init__(self, physics: Physics, cameras: Cameras) -> None:
        super().__init__(_bare_table(physics.arm).__copy__(), physics.arm)
        self._physics = physics
        self._cameras = cameras
        self._ground = self._model.geom("heights").id
        self._map = HeightMap({})
        self._grasped: tuple[str, Array] | None = None
        self._load: tuple[str, Array] | None = None

    def refresh(self) -> None:
        """Look where everything is now."""
        self._show(HeightMap(self._cameras.current()))

    def recall(self) -> None:
        """Go by what was last seen in this action."""
        self._show(HeightMap(self._cameras.latest()))

    @contextmanager
    def carrying(self, name: str) -> Iterator[None]:
        """Within this, the object moves with the hand and is itself tested against obstacles."""
        points, _ = self.shape(name)
        tool = np.linalg.inv(self.arm.forward(self._physics.joints))
        before = self._without(name)
        self._load = (name, _thinned(points @ tool[:3, :3].T + tool[:3, 3]))
        try:
            yield
        finally:
            self._load = None
            self._show(before)

    @contextmanager
    def grasping(self, name: str, cloud: Cloud) -> Iterator[None]:
        """Within this, the object's own points, not its heights, are kept clear of the gripper."""
        before = self._without(name)
        self._grasped = (name, _thinned(cloud.points))
        try:
            yield
        finally:
            self._grasped = None
            self._show(before)

    def shape(self, name: str) -> tuple[Array, Array]:
        """Points of an object's surface and its middle, as far as it is seen.

        Raises:
            ActionFailure: it is not seen at all.
        """
        clouds = self._cameras.current()
        if name not in clouds:
            raise ActionFailure(
                "look", f"{name} is hidden or has fallen off the table: no camera sees it"
            )
        cloud = clouds[name]
        middle = (cloud.lowest + cloud.highest) / 2
        foot = middle + FOOT * (cloud.points - middle)
        foot[:, 2] = cloud.lowest[2]
        return np.concatenate([cloud.points, _thinned(foot)]), middle

    def find(self, joints: Array, opening: float, clearance: float) -> Collision | None:
        """The first collision of the arm or of what it carries; see ``Collisions``."""
        tool = self.arm.forward(joints)
        if self._load is not None:
            name, local = self._load
            points = local @ tool[:3, :3].T + tool[:3, 3]
            gap = PASSING if clearance >= CLEARANCE else -OVERLAP
            inside = points[:, 2] < self._map.below(points) + gap
            if inside.sum() >= STRAY:
                return Collision(name, self._map.owner(points[inside].mean(axis=0)))
        if self._grasped is not None:
            name, points = self._grasped
            local = (points - tool[:3, 3]) @ tool[:3, :3]
            if _in_gripper(self.arm, local, opening) >= STRAY:
                return Collision("the gripper", name)
        return super().find(joints, opening, clearance)

    def _without(self, name: str) -> HeightMap:
        """Leave an object out of the map; what the map was before."""
        before = self._map
        others = {other: c for other, c in self._cameras.current().items() if other != name}
        self._show(HeightMap(others))
        return before

    def _show(self, heights: HeightMap) -> None:
        self._map = heights
        # What is all above a height field's top is passed over without a look at its cells.
        top = max(float(heights.heights.max()), LOWEST)
        self._model.hfield_size[0, 2] = top
        # Of a height field, rows run along y, columns along x.
        self._model.hfield_data[:] = (heights.heights.T / top).reshape(-1)

    def _bring_along(self, joints: Array) -> None:
        del joints  # Unused: what is carried is no geom of the model.

    def _label(self, geom: int, place: Array) -> str:
        if geom == self._ground:
            return self._map.owner(place)
        if self._is_robot[geom]:
            return self._robot_label(geom)
        return f"the {self._model.geom(geom).name or 'table'}"


def _in_gripper(arm: Arm, points: Array, opening: float) -> int:
    """How many points (n, 3), in the tool frame, lie inside the fingers or the hand."""
    across, closing, along = points.T
    (half_x, half_y, half_z), (_, middle_y, middle_z) = arm.finger
    finger = (np.abs(across) < half_x - SKIN) & (np.abs(along - middle_z) < half_z - SKIN)
    finger &= np.abs(np.abs(closing) - opening - middle_y) < half_y - SKIN
    (half_x, half_y, half_z), (_, _, middle_z) = arm.palm
    hand = (np.abs(across) < half_x - SKIN) & (np.abs(along - middle_z) < half_z - SKIN)
    hand &= np.abs(closing) < half_y - SKIN
    return int((finger | hand).sum())


def _thinned(points: Array) -> Array:
    """At most ``THINNED`` of the points, evenly chosen."""
    step = max(1, len(points) // THINNED)
    return points[::step]


@cache
def _bare_table(arm: Arm) -> mujoco.MjModel:
    """The arm at a table that bears nothing but a height map."""
    spec = furnished(arm, visuals=False).copy()
    half = [CELL * (count - 1) / 2 for count in COUNT]
    spec.add_hfield(
        name="heights",
        nrow=COUNT[1],
        ncol=COUNT[0],
        size=(*half, HIGHEST, 0.01),
        userdata=np.zeros(COUNT[0] * COUNT[1]),
    )
    spec.worldbody.add_geom(
        name="heights",
        type=mujoco.mjtGeom.mjGEOM_HFIELD,
        hfieldname="heights",
        pos=(CORNER[0] + half[0], CORNER[1] + half[1], 0.0),
    )
    return spec.compile()
