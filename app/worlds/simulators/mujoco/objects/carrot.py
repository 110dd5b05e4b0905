import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import lying, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("carrot")
class Carrot(Kind):
    name = "carrot"
    category = "vegetable"
    synonyms = ("parsnip",)
    colour = "#ee7a1c"
    smallest = (0.140, 0.026, 0.026)
    largest = (0.170, 0.034, 0.034)
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A ridged cone lying along x with a tuft of green."""
        length, width, height = size
        share = np.linspace(0, 1, 21)
        radii = 0.5 * (1 - 0.8 * share**1.3)
        radii[1:-1] -= 0.012 * (np.arange(1, 20) % 4 == 0)
        radii[[0, -1]] = 0.36, 0.02
        root = [(0, 0), *zip((radii * width).tolist(), (share * length).tolist(), strict=True)]
        flesh = (0.8 * length, width, height)
        solid.show(colour, lying([*root, (0, length)]).fitted(flesh).moved(0.1 * length))
        solid.hull(lying(root[1::4], 12).fitted(flesh).moved(0.1 * length).vertices)
        tops = [
            tube([(0, 0, 0), (-0.12, y, z / 2), (-0.19, 2 * y, z)] * np.array(length), radii, 8)
            for y, z in ((0.0, 0.05), (0.02, 0.03), (-0.02, 0.02), (0.01, -0.01), (-0.01, 0.0))
            for radii in ([0.0018, 0.0022, 0.0012],)
        ]
        back = (-0.3 * length, 0, 0.45 * height)
        solid.show(css("#4c9a2a"), *(stalk.moved(*back) for stalk in tops))
