import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("banana")
class Banana(Kind):
    name = "banana"
    category = "fruit"
    synonyms = ("plantain",)
    colour = "#f2cf3b"
    smallest = (0.150, 0.064, 0.032)
    largest = (0.180, 0.074, 0.036)
    density = 550.0

    def grip(self, size: Size) -> float:
        return size[2]  # across the fruit, which is as thick as it is high

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """An arc lying on its side: a tapering tube with dark ends over a chain of hulls."""
        length, width, height = size
        thick = height / 2
        share = np.linspace(-1, 1, 17)
        radii = thick * (1 - 0.6 * share**2)
        bow = width - thick - radii[0]  # how far the middle stands out over the ends
        path = np.column_stack(
            [
                share * (length / 2 - 0.005),
                bow * (1 - share**2) - width / 2 + radii[0],
                radii,
            ]
        )
        solid.show(colour, tube(path[1:-1], radii[1:-1]))
        dark = css("#4a3b18")
        solid.show(dark, tube(path[:2], 0.9 * radii[:2]), tube(path[-2:], 0.9 * radii[-2:]))
        for first in range(1, 14, 3):
            part = slice(first, first + 4)
            solid.hull(tube(path[part], radii[part], segments=8).vertices)
