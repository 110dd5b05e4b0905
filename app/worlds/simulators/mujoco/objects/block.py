from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("block")
class Block(Kind):
    name = "block"
    category = "toy"
    synonyms = ("cube", "brick", "building block", "dice", "die", "lego")
    colour = "#3f6fd1"
    smallest = (0.036, 0.036, 0.036)
    largest = (0.050, 0.050, 0.050)
    density = 700.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        half = tuple(side / 2 for side in size)
        solid.box(half, (0, 0, half[2]))
        solid.show(colour, box(half, (0, 0, half[2]), bevel=0.0025))
