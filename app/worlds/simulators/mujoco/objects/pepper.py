import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Points, revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("pepper")
class Pepper(Kind):
    name = "pepper"
    category = "vegetable"
    synonyms = ("bell pepper", "capsicum", "paprika")
    colour = "#d9342b"
    smallest = (0.060, 0.060, 0.070)
    largest = (0.070, 0.070, 0.082)
    round = True
    density = 350.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Four lobes on a flat bottom, a green stalk sunk into the top."""
        width, _, height = size

        def lobes(points: Points) -> Points:
            dent = 1 - 0.05 * (1 - np.cos(4 * np.arctan2(points[:, 1], points[:, 0])))
            return points * np.column_stack([dent, dent, np.ones(len(points))])

        outline = [(0, 0.03), (0.2, 0), (0.34, 0.03), (0.43, 0.2), (0.49, 0.5), (0.5, 0.68)]
        outline += [(0.44, 0.82), (0.3, 0.88), (0.15, 0.84), (0, 0.8)]
        profile = [(radius * width, z * height) for radius, z in outline]
        solid.show(colour, revolve(profile, segments=48).bent(lobes))
        solid.hull(revolve(profile[1:8], segments=14).vertices)
        stalk = [(0, 0, 0.79 * height), (0, 0, 0.9 * height), (0.004, 0, height - 0.001)]
        solid.show(css("#4f8a34"), tube(stalk, [0.007, 0.0035, 0.0045], 10))
