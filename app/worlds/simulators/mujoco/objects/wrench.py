from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("wrench")
class Wrench(Kind):
    name = "wrench"
    category = "tool"
    synonyms = ("spanner", "pliers", "allen key", "clamp")
    colour = "#9aa1a9"
    smallest = (0.160, 0.044, 0.014)
    largest = (0.190, 0.052, 0.017)
    density = 3000.0

    def grip(self, size: Size) -> float:
        return 0.4 * size[1]  # across the shank

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A flat shank with an open jaw at one end and a ring at the other."""
        length, width, height = size
        x, y, z = length / 2, width / 2, height / 2
        shank = ((0.62 * x, 0.4 * y, z), (-0.05 * x, 0, z))
        solid.box(*shank)
        inset = ((0.42 * x, 0.22 * y, 0.0004), (-0.05 * x, 0, height - 0.0003))
        solid.show(shade(colour, 0.7), box(*inset))
        jaw = ((0.2 * x, y, z), (0.62 * x, 0, z))
        solid.box(*jaw)
        solid.show(colour, box(*shank, bevel=0.002), box(*jaw, bevel=0.003))
        for side in (-1, 1):
            prong = ((0.09 * x, 0.27 * y, z), (0.91 * x, side * 0.73 * y, z))
            solid.box(*prong)
            solid.show(colour, box(*prong, bevel=0.003))
        ring = 0.92 * y
        solid.cylinder(ring, (ring - x, 0, 0), (ring - x, 0, height))
        eye = [(0.55, 0), (1, 0), (1, 1), (0.55, 1), (0.55, 0)]
        solid.show(colour, revolve([(r * ring, h * height) for r, h in eye]).moved(ring - x))
