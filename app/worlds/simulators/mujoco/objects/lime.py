from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("lime")
class Lime(Kind):
    name = "lime"
    category = "fruit"
    colour = "#79b82c"
    smallest = (0.056, 0.048, 0.046)
    largest = (0.064, 0.054, 0.052)
    density = 950.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its side; a little button at one end."""
        length, width, height = size
        half = (0.48 * length, width / 2, height / 2)
        spot = (-0.02 * length, 0, half[2])
        solid.ellipsoid(half, spot)
        solid.show(colour, ellipsoid(half, spot, rings=16))
        tip = ellipsoid((0.07 * length, 0.1 * width, 0.1 * height))
        solid.show(shade(colour, 0.8), tip.moved(0.43 * length, 0, half[2]))
