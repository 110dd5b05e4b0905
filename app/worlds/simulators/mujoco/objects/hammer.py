import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, hull, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("hammer")
class Hammer(Kind):
    name = "hammer"
    category = "tool"
    synonyms = ("mallet", "axe", "hatchet")
    colour = "#b5793d"
    smallest = (0.210, 0.090, 0.026)
    largest = (0.240, 0.105, 0.030)
    density = 1100.0

    def grip(self, size: Size) -> float:
        return 0.85 * size[2]  # across the handle

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A wooden handle along x; a steel head with a round face and a wedge across its end."""
        length, width, height = size
        head, axis = 0.055 * length, height / 2
        front = length / 2 - 1.02 * axis
        half = ((front + length / 2) / 2, self.grip(size) / 2, axis)
        spot = (front - half[0], 0, axis)
        solid.box(half, spot)
        solid.show(colour, box(half, spot, bevel=0.006))
        steel = css("#7d838b")
        cheek = ((1.02 * axis, 0.2 * width, axis), (front, 0, axis))
        solid.box(*cheek)
        solid.show(steel, box(*cheek, bevel=0.003))
        face = [(0, 0.5), (0.95, 0.5), (1, 0.48), (1, 0.34), (0.75, 0.3), (0.75, 0.15)][::-1]
        poll = revolve([(r * axis, y * width) for r, y in face], 24).turned("x", -np.pi / 2)
        solid.show(steel, poll.moved(front, 0, axis))
        solid.cylinder(axis, (front, 0.34 * width, axis), (front, width / 2, axis))
        solid.cylinder(0.75 * axis, (front, 0.15 * width, axis), (front, 0.34 * width, axis))
        wedge = [
            (x, y, z)
            for y, deep in ((-0.15, 0.9), (-0.5, 0.12))
            for x in (-1.0, 1.0)
            for z in (-deep, deep)
        ]
        corners = np.array(wedge) * (head, width, axis) + (front, 0, axis)
        solid.hull(corners)
        solid.show(steel, hull(corners).faceted())
