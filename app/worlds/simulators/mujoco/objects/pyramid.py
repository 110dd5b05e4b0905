import numpy as np

from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import hull
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("pyramid")
class Pyramid(Kind):
    name = "pyramid"
    category = "toy"
    synonyms = ("toy pyramid",)
    colour = "#8e5ea2"
    smallest = (0.052, 0.052, 0.046)
    largest = (0.066, 0.066, 0.060)
    density = 600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Four flat sides and a blunt top."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        square = np.array([(1, 1), (1, -1), (-1, -1), (-1, 1)])
        levels = ((0.0, 1.0), (0.14, 1.0), (1.0, 0.12))
        points = [(a * x * s, b * y * s, z * height) for z, s in levels for a, b in square]
        solid.hull(np.array(points, float))
        solid.show(colour, hull(np.array(points, float)).faceted())
