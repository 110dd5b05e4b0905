import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import lying, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("cucumber")
class Cucumber(Kind):
    name = "cucumber"
    category = "vegetable"
    synonyms = ("zucchini", "courgette", "pickle", "gherkin")
    colour = "#3f7d3a"
    smallest = (0.150, 0.034, 0.034)
    largest = (0.185, 0.042, 0.042)
    density = 800.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A rounded rod along x with paler stripes and a stub of stalk."""
        length, width, height = size
        outline = [(0, 0), (0.3, 0.005), (0.42, 0.03), (0.48, 0.1), (0.5, 0.3), (0.5, 0.7)]
        outline += [(0.47, 0.9), (0.38, 0.97), (0.22, 1.0), (0, 1.0)]
        flesh = (0.96 * length, width, height)
        solid.show(colour, lying(outline).fitted(flesh).moved(-0.02 * length))
        solid.hull(lying(outline[1:9:2], 12).fitted(flesh).moved(-0.02 * length).vertices)
        along = np.linspace(-0.38, 0.34, 9) * length
        for angle in np.linspace(0.3, np.pi - 0.3, 5):
            y, z = 0.487 * width * np.cos(angle), height / 2 + 0.487 * height * np.sin(angle)
            path = np.column_stack([along, np.full(9, y), np.full(9, z)])
            solid.show(shade(colour, 1.35), tube(path, np.full(9, 0.0009), 6))
        stub = tube([(0.45 * length, 0, 0), (0.5 * length, 0, 0)], [0.004, 0.0045], 8)
        solid.show(css("#7fa05a"), stub.moved(0, 0, height / 2))
