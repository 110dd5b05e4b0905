from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("neutral")
class Neutral(Kind):
    """What an object of unknown kind is built as, so that any name can be planned and executed."""

    name = "neutral"
    category = "object"
    colour = "#8d99ae"
    smallest = (0.050, 0.040, 0.036)
    largest = (0.070, 0.050, 0.050)
    density = 600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        half = tuple(side / 2 for side in size)
        solid.box(half, (0, 0, half[2]))
        solid.show(colour, box(half, (0, 0, half[2]), bevel=0.005))
        mark = box((0.25 * size[0], 0.25 * size[1], 0.0004), (0, 0, size[2] - 0.0003))
        solid.show(shade(colour, 1.6), mark)
