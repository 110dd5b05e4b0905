"""Picture: what a colour camera shows, drawn from rays or, where MuJoCo can render, by OpenGL."""

import io
import logging
import os
from collections.abc import Callable
from functools import cached_property

import mujoco
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from app.worlds.simulators.mujoco.camera import Camera
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.raycast import cast

Pixels = NDArray[np.uint8]
"""Shape (height, width, 3)."""

DRAWN = (320, 240)
"""Width and height of a picture made of rays."""
RENDERED = (640, 480)
"""The same of a rendered one."""
LOOKS = np.array([1, 1, 1, 0, 0, 0], np.uint8)
"""The geometry groups that are to be looked at."""
LIGHT = np.array([0.25, 0.2, 0.95])
"""Where the light comes from, base frame."""
AMBIENT = 0.55
"""How bright a surface is that no light falls on, of 1."""
NOTHING = (200, 205, 210)
"""The colour of where nothing is."""
log = logging.getLogger(__name__)


class Pictures:
    """Pictures of a scene as it stands.

    They are rendered where ``MUJOCO_GL`` names a way that works without a display (``egl``,
    ``osmesa``), and else drawn from rays: surfaces in their materials' colours, without shadows.
    """

    def __init__(self, physics: Physics, model: Callable[[], mujoco.MjModel]) -> None:
        """Prepare.

        Args:
            physics: the scene in motion; its model may lack what is only to be looked at.
            model: the same scene with it; the same coordinates. Built at the first picture.
        """
        self._physics = physics
        self._build = model

    def take(self, camera: Camera) -> Pixels:
        """What the camera shows now."""
        self._data.qpos[:] = self._physics.data.qpos
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        if self._renderer is None:
            return self._drawn(camera)
        return self._rendered(self._renderer, camera)

    @cached_property
    def _model(self) -> mujoco.MjModel:
        model = self._build()
        model.vis.global_.offwidth, model.vis.global_.offheight = RENDERED
        return model

    @cached_property
    def _data(self) -> mujoco.MjData:
        return mujoco.MjData(self._model)

    @cached_property
    def _renderer(self) -> mujoco.Renderer | None:
        if os.environ.get("MUJOCO_GL", "").lower() not in ("egl", "osmesa"):
            return None
        try:
            return mujoco.Renderer(self._model, RENDERED[1], RENDERED[0])
        except Exception as error:  # whatever a graphics library may come up with
            log.warning("pictures are drawn from rays, since none can be rendered: %s", error)
            return None

    def _rendered(self, renderer: mujoco.Renderer, camera: Camera) -> Pixels:
        # The free camera stands where it is told by what it looks at, how far off and from where.
        self._model.vis.global_.fovy = np.degrees(camera.field_of_view)
        forward = camera.axes()[2]
        view = mujoco.MjvCamera()
        view.type = mujoco.mjtCamera.mjCAMERA_FREE
        view.distance = 1.0
        view.lookat = np.array(camera.position) + forward
        view.azimuth = np.degrees(np.arctan2(forward[1], forward[0]))
        view.elevation = np.degrees(np.arcsin(forward[2]))
        renderer.update_scene(self._data, view)
        return renderer.render().copy()

    def _drawn(self, camera: Camera) -> Pixels:
        width, height = DRAWN
        rows, columns = (grid.ravel() for grid in np.mgrid[:height, :width])
        met = cast(self._model, self._data, camera, DRAWN, (rows, columns), LOOKS)
        light = np.maximum(met.normals @ (LIGHT / np.linalg.norm(LIGHT)), 0.0)
        colours = self._colours[met.geoms] * (AMBIENT + (1 - AMBIENT) * light)[:, None]
        seen = np.where(met.geoms[:, None] >= 0, 255 * colours, NOTHING)
        return seen.round().astype(np.uint8).reshape(height, width, 3)

    @cached_property
    def _colours(self) -> NDArray[np.float64]:
        """Of every geom, shape (ngeom, 3), in [0, 1]."""
        material = self._model.geom_matid
        colours = self._model.geom_rgba[:, :3].copy()
        made_of = material >= 0
        colours[made_of] = self._model.mat_rgba[material[made_of], :3]
        return colours


def png(pixels: Pixels) -> bytes:
    """The picture as a file."""
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    return file.getvalue()
