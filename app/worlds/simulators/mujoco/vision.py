"""Vision: a detector that is told in pictures where the objects are, and looks for them in space.

Boxes and points in the pictures become masks, masks become labelled points, and whatever a ray hits
is labelled as the labelled point next to it. Which pixels show the table or the arm is known, as it
would be from a picture of the empty table and from the arm's joints.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import KDTree

from app.domain.sighting import Finder, Sighting
from app.worlds.simulators.mujoco.camera import CAMERAS, Camera
from app.worlds.simulators.mujoco.detector import SOMETHING_ELSE, Labels
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.picture import Pictures, Pixels, png
from app.worlds.simulators.mujoco.raycast import cast

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

ASKED = CAMERAS[:3]
"""The cameras whose pictures the finder gets."""
GRID = (160, 120)
"""Width and height of the masks."""
GROUPS = np.array([1, 0, 0, 1, 0, 0], np.uint8)
REACH = 0.04
"""What is so close to a labelled point is of the same object [m]."""
MOVED = 0.003
"""An object that moved less is where the pictures showed it [m]."""
SIMILAR = 0.12
"""Colours no farther apart than this, each in [0, 1], are of one surface."""


class Vision:
    """A ``Detector`` over a ``Finder``. It asks again only where an object has moved since."""

    def __init__(
        self, physics: Physics, pictures: Pictures, finder: Finder, names: Sequence[str]
    ) -> None:
        """Prepare; nothing is asked yet."""
        self._physics, self._pictures, self._finder = physics, pictures, finder
        self._names = list(names)
        self._is_object = np.zeros(physics.model.nbody, bool)
        for body in physics.bodies.values():
            self._is_object[list(body.parts)] = True
        self._places: Array | None = None
        self._tree: KDTree | None = None
        self._owners = np.zeros(0, np.int32)

    def label(self, bodies: Labels, points: Array) -> Labels:
        """What each pixel shows; see ``Detector``."""
        self._look()
        labels = np.full(bodies.shape, SOMETHING_ELSE, np.int32)
        objects = self._is_object[bodies]
        if self._tree is None or not objects.any():
            return labels
        apart, nearest = self._tree.query(points[objects], distance_upper_bound=REACH)
        owners = self._owners[np.minimum(nearest, len(self._owners) - 1)]
        labels[objects] = np.where(np.isfinite(apart), owners, SOMETHING_ELSE)
        return labels

    def _look(self) -> None:
        """Have the pictures searched, if they would show something new."""
        data = self._physics.stand()
        places = data.xpos[self._is_object].copy()
        if self._places is not None and np.abs(places - self._places).max(initial=0.0) < MOVED:
            return
        self._places = places
        labels, points = zip(*(self._searched(camera) for camera in ASKED), strict=True)
        self._owners = np.concatenate(labels)
        found = np.concatenate(points)
        self._tree = KDTree(found) if len(found) else None

    def _searched(self, camera: Camera) -> tuple[Labels, Array]:
        """Labels (n,) and points (n, 3) of what the finder names in one camera's picture."""
        width, height = GRID
        picture = self._pictures.take(camera)
        sightings = self._finder.find(png(picture), self._names)
        rows, columns = (grid.ravel() for grid in np.mgrid[:height, :width])
        met = cast(
            self._physics.model, self._physics.stand(), camera, GRID, (rows, columns), GROUPS
        )
        objects = (met.geoms >= 0) & self._is_object[self._physics.model.geom_bodyid[met.geoms]]
        marked = masks(sightings, objects.reshape(height, width), _shrunk(picture))
        labels = np.full(height * width, SOMETHING_ELSE, np.int32)
        for name, mask in marked.items():
            labels[mask.ravel()] = self._names.index(name)
        seen = labels >= 0
        return labels[seen], met.points[seen]


def masks(sightings: Sequence[Sighting], objects: Mask, colours: Array) -> dict[str, Mask]:
    """Which pixels show what was found.

    A pixel in several boxes is of the smallest one whose middle has its colour, and else of the
    largest: a banana in a bowl has its box in the bowl's.

    Args:
        sightings: in the picture.
        objects: the pixels that show any object, shape (height, width).
        colours: of the pixels, shape (height, width, 3), in [0, 1].
    """
    boxed = sorted((each for each in sightings if each.box), key=_area)
    boxes = [_inside(each, objects.shape) & objects for each in boxed]
    free, found = objects.copy(), dict[str, Mask]()
    for index, (sighting, box) in enumerate(zip(boxed, boxes, strict=True)):
        mine = box & free
        shared = np.any([mine & other for other in boxes[index + 1 :]], axis=0)
        if np.any(shared):
            mine &= ~shared | _alike(colours, _middle_colour(sighting, box, colours))
        found[sighting.name] = mine
        free &= ~mine
    for sighting in sightings:
        if sighting.point and not sighting.box:
            found[sighting.name] = _around(sighting.point, free, colours)
            free &= ~found[sighting.name]
    return found


def _area(sighting: Sighting) -> float:
    left, top, right, bottom = sighting.box or (0.0, 0.0, 0.0, 0.0)
    return (right - left) * (bottom - top)


def _inside(sighting: Sighting, shape: tuple[int, ...], share: float = 1.0) -> Mask:
    """The pixels in a box, or in the middle ``share`` of it."""
    left, top, right, bottom = sighting.box or (0.0, 0.0, 0.0, 0.0)
    down, across = np.linspace(0, 1, shape[0]), np.linspace(0, 1, shape[1])
    rows = np.abs(down - (top + bottom) / 2) <= share * (bottom - top) / 2
    columns = np.abs(across - (left + right) / 2) <= share * (right - left) / 2
    return rows[:, None] & columns


def _middle_colour(sighting: Sighting, box: Mask, colours: Array) -> Array:
    middle = box & _inside(sighting, box.shape, 0.5)
    return np.median(colours[middle if middle.any() else box], axis=0)


def _alike(colours: Array, colour: Array) -> Mask:
    return np.abs(colours - colour).max(axis=-1) < SIMILAR


def _around(point: tuple[float, float], free: Mask, colours: Array) -> Mask:
    """The patch of one colour about a place."""
    across, down = point
    row, column = round(down * (free.shape[0] - 1)), round(across * (free.shape[1] - 1))
    patches = np.zeros(free.shape, np.int32)
    ndimage.label(free & _alike(colours, colours[row, column]), output=patches)
    return (patches == patches[row, column]) & (patches > 0)


def _shrunk(picture: Pixels) -> Array:
    """The colours of the grid's pixels, in [0, 1]."""
    width, height = GRID
    rows = np.linspace(0, picture.shape[0] - 1, height).round().astype(int)
    columns = np.linspace(0, picture.shape[1] - 1, width).round().astype(int)
    return picture[np.ix_(rows, columns)] / 255.0
