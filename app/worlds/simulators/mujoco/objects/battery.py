from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("battery")
class Battery(Kind):
    name = "battery"
    category = "tool"
    synonyms = ("batteries", "cell", "accumulator", "power cell")
    colour = "#3d405b"
    smallest = (0.030, 0.030, 0.058)
    largest = (0.036, 0.036, 0.066)
    round = True
    density = 1600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A standing cell with a copper top and a pole."""
        radius, height = size[0] / 2, size[2]
        body = 0.94 * height
        solid.show(colour, revolve([(0, 0), (radius, 0), (radius, 0.7 * body)]))
        solid.show(css("#c07a3a"), revolve([(radius, 0.7 * body), (radius, body), (0, body)]))
        pole = [(0.3 * radius, body), (0.3 * radius, height), (0, height)]
        solid.show(css("#d6d8da"), revolve(pole))
        solid.cylinder(radius, (0, 0, 0), (0, 0, body))
