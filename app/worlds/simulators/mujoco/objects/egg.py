import numpy as np

from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("egg")
class Egg(Kind):
    name = "egg"
    category = "food"
    synonyms = ("boiled egg", "easter egg")
    colour = "#ecd2b0"
    smallest = (0.054, 0.042, 0.042)
    largest = (0.062, 0.047, 0.046)
    density = 1000.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its side, one end blunter than the other."""
        around = np.linspace(0, np.pi, 17)
        radius = np.sin(around) * (1 + 0.12 * np.cos(around))
        radius[[0, -1]] = 0
        outline = list(zip(radius.tolist(), (1 - np.cos(around)).tolist(), strict=True))
        solid.show(colour, revolve(outline).turned("y", np.pi / 2).fitted(size))
        half = tuple(side / 2 for side in size)
        solid.ellipsoid(half, (0, 0, half[2]))
