import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import lying, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("pen")
class Pen(Kind):
    name = "pen"
    category = "stationery"
    synonyms = ("pencil", "ballpoint", "biro", "stylus", "paintbrush", "chopstick", "toothbrush")
    colour = "#22314f"
    smallest = (0.135, 0.011, 0.011)
    largest = (0.150, 0.014, 0.014)
    density = 700.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Six-sided, so that it does not roll; a metal tip, a light end, a clip."""
        length, width, height = size
        body = (0.8 * length, width, height)
        barrel = lying([(0, 0), (0.5, 0), (0.5, 1), (0, 1)], 6).fitted(body)
        solid.show(colour, barrel.faceted().moved(-0.02 * length))
        solid.hull(barrel.moved(-0.02 * length).vertices)
        cone = [(0, 0), (0.42, 0), (0.3, 0.05), (0.1, 0.11), (0.06, 0.12), (0, 0.12)]
        tip = revolve([(r * height, z * length) for r, z in cone], 14).turned("y", np.pi / 2)
        solid.show(css("#c4c8cd"), tip.moved(0.38 * length, 0, 0.47 * height))
        solid.capsule(0.12 * height, (0.38 * length, 0, height / 2), (0.48 * length, 0, height / 2))
        knob = revolve([(0, 0), (0.34, 0), (0.4, 0.02), (0.4, 0.08), (0, 0.08)], 14)
        knob = knob.scaled(height, height, length).turned("y", np.pi / 2)
        solid.show(css("#e9e4d8"), knob.moved(-0.5 * length, 0, 0.47 * height))
