from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("kiwi")
class Kiwi(Kind):
    name = "kiwi"
    category = "fruit"
    synonyms = ("kiwi fruit", "kiwifruit")
    colour = "#80623a"
    smallest = (0.058, 0.046, 0.044)
    largest = (0.068, 0.052, 0.050)
    density = 800.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its side; a dark tuft at one end, a paler spot at the other."""
        length, width, height = size
        half = (length / 2, width / 2, height / 2)
        solid.ellipsoid(half, (0, 0, half[2]))
        solid.show(colour, ellipsoid(half, (0, 0, half[2]), rings=16))
        tuft = ellipsoid((0.03 * length, 0.12 * width, 0.12 * height), (0.465 * length, 0, half[2]))
        spot = ellipsoid((0.03 * length, 0.14 * width, 0.14 * height), (-0.46 * length, 0, half[2]))
        solid.show(css("#4a3820"), tuft)
        solid.show(shade(colour, 1.35), spot)
