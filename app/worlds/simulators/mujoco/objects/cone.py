from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("cone")
class Cone(Kind):
    name = "cone"
    category = "toy"
    synonyms = ("traffic cone", "party hat")
    colour = "#e8682a"
    smallest = (0.056, 0.056, 0.070)
    largest = (0.068, 0.068, 0.090)
    round = True
    density = 300.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A blunt cone on a round foot, with a light band."""
        radius, height = size[0] / 2, size[2]
        foot = [(0, 0), (radius, 0), (radius, 0.008)]
        flank = [(0.80 * radius, 0.009), (0.16 * radius, height - 0.002), (0, height)]
        solid.show(colour, revolve([*foot, *flank]))
        band = [(0.56 * radius, 0.42 * height), (0.42 * radius, 0.62 * height)]
        solid.show(css("#f4f1e6"), revolve(band))
        solid.cylinder(radius, (0, 0, 0), (0, 0, 0.008))
        solid.hull(revolve([(0.80 * radius, 0.008), *flank[1:]], 16).vertices)
