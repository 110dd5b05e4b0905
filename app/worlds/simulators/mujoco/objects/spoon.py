import numpy as np

from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("spoon")
class Spoon(Kind):
    name = "spoon"
    category = "cutlery"
    synonyms = ("teaspoon", "tablespoon", "ladle", "spatula", "whisk", "scoop")
    colour = "#c2c6cc"
    smallest = (0.160, 0.034, 0.015)
    largest = (0.185, 0.040, 0.018)
    density = 2500.0

    def grip(self, size: Size) -> float:
        return min(0.013, 0.4 * size[1])  # across the handle

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A bowl, hollow to the eye, and a handle that its thick end holds up."""
        length, width, height = size
        half, back, scoop = self.grip(size) / 2, -length / 2, 0.16 * length
        stem = (0.36 * length, half, 0.0035)
        spot = (back + stem[0], 0, height - 0.0035)
        foot = ((0.035 * length, half, height / 2), (back + 0.035 * length, 0, height / 2))
        for part in ((stem, spot), foot):
            solid.box(*part)
            solid.show(colour, box(*part, bevel=0.0022))
        middle = length / 2 - scoop
        solid.ellipsoid((scoop, width / 2, 0.32 * height), (middle, 0, 0.32 * height))
        rim, deep = np.linspace(-np.pi / 2, 0, 9), np.linspace(0, -np.pi / 2, 9)
        shell = [(float(np.cos(a)), float(np.sin(a))) for a in rim]
        shell += [(0.9 * float(np.cos(a)), 0.8 * float(np.sin(a))) for a in deep]
        shell[0], shell[-1] = (0.0, -1.0), (0.0, -0.8)
        dish = revolve(shell, 28).scaled(scoop, width / 2, 0.64 * height)
        solid.show(colour, dish.moved(middle, 0, 0.64 * height))
        start, end = middle - 0.95 * scoop, back + 1.95 * stem[0]
        neck = [(end, 0, height - 0.004), (start, 0, 0.66 * height)]
        solid.show(colour, tube(neck, [0.0032, 0.0028], 10))
        solid.capsule(0.003, *neck)
