from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("plum")
class Plum(Kind):
    name = "plum"
    category = "fruit"
    synonyms = ("prune", "fig", "grape", "cherry", "date")
    colour = "#6b2a5b"
    smallest = (0.042, 0.036, 0.036)
    largest = (0.052, 0.044, 0.042)
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its side, a stem at one end."""
        length, width, height = size
        half = (0.46 * length, width / 2, height / 2)
        spot = (-0.04 * length, 0, half[2])
        solid.ellipsoid(half, spot)
        solid.show(colour, ellipsoid(half, spot, rings=16))
        stem = tube([(0.40 * length, 0, half[2]), (0.5 * length, 0, half[2])], [0.002, 0.0014], 8)
        solid.show(css("#5b3a1e"), stem)
