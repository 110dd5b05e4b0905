import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Points, ellipsoid
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("potato")
class Potato(Kind):
    name = "potato"
    category = "vegetable"
    synonyms = ("sweet potato", "yam", "ginger")
    colour = "#c49a5c"
    smallest = (0.078, 0.054, 0.046)
    largest = (0.096, 0.066, 0.056)
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A lumpy ellipsoid with a few eyes."""
        half = tuple(side / 2 for side in size)

        def lumps(points: Points) -> Points:
            x, y, z = points.T
            bump = np.sin(3.1 * x + 1) * np.cos(2.7 * y) + np.sin(2.3 * z + 2 * x)
            return points * (1 + 0.05 * bump)[:, None]

        body = ellipsoid((1, 1, 1), rings=18).bent(lumps).fitted(size)
        solid.show(colour, body)
        solid.ellipsoid(half, (0, 0, half[2]))
        eyes = [body.vertices[i] for i in (140, 207, 262, 331, 420, 455)]
        dots = [ellipsoid((0.002, 0.002, 0.0012), 0.985 * eye, rings=6) for eye in eyes]
        solid.show(shade(colour, 0.6), *dots)
