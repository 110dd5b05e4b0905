import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Points, ellipsoid, globe
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("peach")
class Peach(Kind):
    name = "peach"
    category = "fruit"
    synonyms = ("nectarine", "apricot")
    colour = "#f2a06b"
    smallest = (0.058, 0.058, 0.056)
    largest = (0.068, 0.068, 0.064)
    round = True
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A globe with a crease down one side and a leaf."""
        width, _, height = size
        flesh = 0.96 * height

        def crease(points: Points) -> Points:
            depth = 0.07 * np.exp(-((np.arctan2(points[:, 1], points[:, 0]) / 0.22) ** 2))
            return points * np.column_stack([1 - depth, 1 - depth, np.ones(len(points))])

        solid.ellipsoid((width / 2, width / 2, flesh / 2), (0, 0, flesh / 2))
        solid.show(colour, globe(width, flesh, dimple=0.07 * width, segments=40).bent(crease))
        leaf = ellipsoid((0.24 * width, 0.09 * width, 0.0012)).turned("y", -0.15)
        solid.show(css("#5f9a3a"), leaf.moved(-0.18 * width, 0, 0.94 * height))
