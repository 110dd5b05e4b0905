from collections.abc import Callable

import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Points, box, ellipsoid
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("cracker_box")
class CrackerBox(Kind):
    """A closed carton."""

    name = "cracker_box"
    category = "food"
    synonyms = (
        *(
            "cereal box",
            "sugar box",
            "pudding box",
            "gelatin box",
            "juice box",
            "tea box",
            "carton",
        ),
        *("cereal", "cracker", "cookie box", "milk carton", "milk", "juice", "package", "packet"),
        *("gift box", "tissue box", "match box", "matchbox", "parcel", "chip", "pasta", "rice"),
    )
    colour = "#c8352f"
    smallest = (0.090, 0.046, 0.120)
    largest = (0.110, 0.056, 0.150)
    density = 220.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Printed card: a light panel and a coloured disc in front and behind, a seam on top."""
        x, y, z = (side / 2 for side in size)
        solid.box((x, y, z), (0, 0, z))
        solid.show(colour, box((x - 0.0005, y - 0.0005, z), (0, 0, z), bevel=0.001))
        panel = box((0.78 * x, y, 0.3 * z), (0, 0, 0.62 * z))
        seam = box((0.9 * x, 0.0006, 0.0003), (0, 0, 2 * z - 0.0003))
        solid.show(css("#f7ecd2"), panel, seam)
        disc = ellipsoid((0.4 * x, y, 0.4 * x), rings=18).bent(_flattened(y))
        solid.show(css("#f0b53c"), disc.moved(0, 0, 1.45 * z))


def _flattened(depth: float) -> Callable[[Points], Points]:
    """Presses what stands out in front of and behind the carton flat."""
    return lambda points: np.column_stack(
        [points[:, 0], np.sign(points[:, 1]) * depth, points[:, 2]]
    )
