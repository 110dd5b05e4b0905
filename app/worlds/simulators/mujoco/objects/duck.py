import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, hull
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("duck")
class Duck(Kind):
    name = "duck"
    category = "toy"
    synonyms = (
        "rubber duck",
        "rubber ducky",
        "toy duck",
        "bird",
        "toy animal",
        "dinosaur",
        "toy dinosaur",
    )
    colour = "#f6c915"
    smallest = (0.080, 0.056, 0.064)
    largest = (0.096, 0.066, 0.078)
    density = 250.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A body with a flat foot, a head and a beak."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        belly = ellipsoid((0.96 * x, y, 0.40 * height), (-0.04 * x, 0, 0.26 * height)).vertices
        belly = np.column_stack([belly[:, :2], np.maximum(belly[:, 2], 0.0)])
        solid.hull(belly)
        solid.show(colour, hull(belly))
        crown = 0.26 * height
        solid.ellipsoid((crown, crown, crown), (0.35 * x, 0, height - crown))
        solid.show(colour, ellipsoid((crown, crown, crown), (0.35 * x, 0, height - crown)))
        beak = (0.35 * x + 1.05 * crown, 0, height - 1.1 * crown)
        solid.show(css("#e8682a"), ellipsoid((0.4 * crown, 0.5 * crown, 0.2 * crown), beak, 8))
        for side in (-1, 1):
            eye = (0.35 * x + 0.75 * crown, side * 0.5 * crown, height - 0.68 * crown)
            solid.show(css("#1b1b1b"), ellipsoid((0.0026, 0.0026, 0.0026), eye, 6))
