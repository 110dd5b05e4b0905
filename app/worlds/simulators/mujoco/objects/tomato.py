import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Points, globe, prism, star, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("tomato")
class Tomato(Kind):
    name = "tomato"
    category = "vegetable"
    synonyms = ("cherry tomato",)
    colour = "#dc3023"
    smallest = (0.056, 0.056, 0.048)
    largest = (0.068, 0.068, 0.058)
    round = True
    density = 950.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A flattened globe with slight lobes under a green star."""
        width, _, height = size
        flesh = 0.94 * height

        def lobes(points: Points) -> Points:
            dent = 1 - 0.025 * (1 - np.cos(5 * np.arctan2(points[:, 1], points[:, 0])))
            return points * np.column_stack([dent, dent, np.ones(len(points))])

        solid.ellipsoid((width / 2, width / 2, flesh / 2), (0, 0, flesh / 2))
        solid.show(colour, globe(width, flesh, dimple=0.07 * width, segments=40).bent(lobes))
        sepals = prism(star(5, 0.07 * width, 0.27 * width), -0.001, 0.001)
        stem = tube([(0, 0, 0.86 * flesh), (0.002, 0, height)], [0.0025, 0.002], segments=8)
        solid.show(css("#3f8f2f"), sepals.moved(0, 0, 0.95 * flesh), stem)
