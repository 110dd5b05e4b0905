import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, prism, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("knife")
class Knife(Kind):
    name = "knife"
    category = "cutlery"
    synonyms = ("butter knife", "table knife", "cutter", "box cutter", "razor")
    colour = "#3b3b40"
    smallest = (0.180, 0.022, 0.014)
    largest = (0.205, 0.026, 0.017)
    density = 1600.0

    def grip(self, size: Size) -> float:
        return 0.72 * size[1]  # across the handle

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A riveted handle and a metal blade, flat on the table."""
        length, width, height = size
        back = -length / 2
        half = (0.22 * length, self.grip(size) / 2, height / 2)
        spot = (back + half[0], 0, height / 2)
        solid.box(half, spot)
        solid.show(colour, box(half, spot, bevel=0.004))
        rivet = revolve([(0, 0), (0.0025, 0), (0.0025, 0.0008), (0, 0.0008)], 10)
        places = (back + share * length for share in (0.10, 0.22, 0.34))
        solid.show(css("#d8c9a0"), *(rivet.moved(x, 0, height - 0.0006) for x in places))
        x, y = -0.06 * length, width / 2
        edge = [(x, -y), (0.36 * length, -y), (0.46 * length, -0.5 * y), (0.5 * length, 0.5 * y)]
        outline = [*edge, (0.48 * length, y), (x, y)]
        solid.show(css("#cfd3d8"), prism(outline, 0.0, 0.003))
        corners = [(a, b, z) for a, b in outline for z in (0.0, 0.003)]
        solid.hull(np.array(corners))
