"""Beads: what lies in a vessel whose scene says ``contents: beads``, to be poured."""

import mujoco
import numpy as np

from app.domain.scene import SceneObject
from app.worlds.simulators.mujoco.colours import css
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.solid import STIFFNESS, VISUAL_GROUP

COUNT = 12
RADIUS = 0.004
"""Of one bead [m]."""
LAYER = 4
"""So many lie side by side."""
APART = 0.006
"""From the vessel's middle to a bead, along x and along y [m]."""


def has_beads(item: SceneObject) -> bool:
    return dict(item.properties).get("contents") == "beads"


def add_beads(spec: mujoco.MjSpec, body_name: str, item: SceneObject, opening: Opening) -> None:
    """Lay them into a vessel; depth cameras do not see their group, pictures do."""
    assert item.position is not None
    for index in range(COUNT):
        layer, place = divmod(index, LAYER)
        # Turned layer by layer, so that the pile falls together.
        angle = np.pi / 4 + np.pi / 2 * place + 0.4 * layer
        x, y = np.sqrt(2) * APART * np.array([np.cos(angle), np.sin(angle)])
        z = opening.floor + 1.3 * RADIUS + 2.1 * RADIUS * layer
        bead = spec.worldbody.add_body(
            name=f"{body_name}/bead/{index}", pos=np.add(item.position, (x, y, z))
        )
        bead.add_freejoint()
        bead.add_geom(
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            size=(RADIUS, 0, 0),
            group=VISUAL_GROUP,
            rgba=css("#3a6ea5"),
            density=1200.0,
            condim=6,
            friction=(0.2, 0.002, 0.0001),
            priority=1,  # else the vessel's friction, made for being gripped, would hold it
            solref=STIFFNESS,
        )
