from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("candle")
class Candle(Kind):
    name = "candle"
    category = "decoration"
    synonyms = ("tealight", "tea light", "wax candle")
    colour = "#f3e3c3"
    smallest = (0.044, 0.044, 0.080)
    largest = (0.056, 0.056, 0.110)
    round = True
    density = 800.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A pillar with a wick."""
        radius, height = size[0] / 2, size[2]
        top = 0.93 * height
        edge = [(0, 0), (radius, 0), (radius, top), (radius - 0.004, top), (0, top - 0.002)]
        solid.show(colour, revolve(edge, 32))
        solid.show(
            css("#3a3530"), revolve([(0.0018, top - 0.002), (0.0014, height), (0, height)], 8)
        )
        solid.cylinder(radius, (0, 0, 0), (0, 0, top))
