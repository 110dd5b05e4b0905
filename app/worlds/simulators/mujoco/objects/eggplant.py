import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import lying, revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("eggplant")
class Eggplant(Kind):
    name = "eggplant"
    category = "vegetable"
    synonyms = ("aubergine",)
    colour = "#4b2a5e"
    smallest = (0.130, 0.052, 0.052)
    largest = (0.155, 0.062, 0.062)
    density = 500.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A club lying along x under a green cap with a stalk."""
        length, width, height = size
        outline = [(0, 0), (0.2, 0.01), (0.38, 0.07), (0.48, 0.2), (0.5, 0.34), (0.44, 0.56)]
        outline += [(0.32, 0.78), (0.25, 0.9), (0.18, 0.98), (0, 1)]
        flesh = (0.9 * length, width, height)
        solid.show(colour, lying(outline).fitted(flesh).moved(-0.05 * length))
        solid.hull(lying(outline[1::2], 12).fitted(flesh).moved(-0.05 * length).vertices)
        radius = 0.26 * height
        cap = revolve([(0.4 * radius, 0.02), (1.02 * radius, 0.0), (radius, -0.016)][::-1], 24)
        cap = cap.turned("y", np.pi / 2).moved(0.405 * length - 0.012, 0, 1.04 * radius)
        stalk = tube([(0.38 * length, 0, 0), (0.5 * length, 0, 0.003)], [0.005, 0.0045], 8)
        solid.show(css("#5c8f3b"), cap, stalk.moved(0, 0, radius))
