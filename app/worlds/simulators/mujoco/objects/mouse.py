import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, hull
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("mouse")
class Mouse(Kind):
    name = "mouse"
    category = "electronics"
    synonyms = ("computer mouse", "wireless mouse")
    colour = "#4a4e57"
    smallest = (0.096, 0.056, 0.034)
    largest = (0.112, 0.066, 0.040)
    density = 400.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A flat egg, with a wheel."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        shell = ellipsoid((x, y, 0.76 * height), (0, 0, 0.24 * height), 16).vertices
        shell = np.column_stack([shell[:, :2], np.maximum(shell[:, 2], 0.0)])
        solid.hull(shell)
        solid.show(colour, hull(shell))
        wheel = ellipsoid((0.006, 0.002, 0.006), (0.55 * x, 0, 0.82 * height), 10)
        solid.show(css("#c4c8cd"), wheel)
