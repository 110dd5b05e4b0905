from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("cylinder")
class Cylinder(Kind):
    name = "cylinder"
    category = "toy"
    synonyms = ("toy cylinder", "round block", "disc", "disk", "puck")
    colour = "#2a9d8f"
    smallest = (0.044, 0.044, 0.040)
    largest = (0.056, 0.056, 0.060)
    round = True
    density = 600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A turned block with broken edges."""
        radius, height = size[0] / 2, size[2]
        low = [(0, 0), (radius - 0.002, 0), (radius, 0.002)]
        high = [(radius, height - 0.002), (radius - 0.002, height), (0, height)]
        solid.show(colour, revolve([*low, *high], 36))
        solid.cylinder(radius, (0, 0, 0), (0, 0, height))
