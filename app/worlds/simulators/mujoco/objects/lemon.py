import numpy as np

from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("lemon")
class Lemon(Kind):
    name = "lemon"
    category = "fruit"
    synonyms = ("citrus",)
    colour = "#f4dd36"
    smallest = (0.074, 0.050, 0.048)
    largest = (0.086, 0.058, 0.056)
    density = 950.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its side; pointed at both ends."""
        outline = [(0, 0), (0.08, 0.01), (0.13, 0.06), (0.26, 0.13), (0.42, 0.28), (0.5, 0.5)]
        outline += [(0.43, 0.72), (0.28, 0.87), (0.14, 0.94), (0.07, 0.99), (0, 1)]
        solid.show(colour, revolve(outline).turned("y", np.pi / 2).fitted(size))
        length, width, height = size
        solid.ellipsoid((0.45 * length, width / 2, height / 2), (0, 0, height / 2))
        tip, axis = 0.06 * height, height / 2
        solid.capsule(tip, (tip - length / 2, 0, axis), (length / 2 - tip, 0, axis))
