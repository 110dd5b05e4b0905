from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("mushroom")
class Mushroom(Kind):
    name = "mushroom"
    category = "vegetable"
    synonyms = ("champignon", "toadstool", "fungus", "cauliflower", "broccoli")
    colour = "#d9b48f"
    smallest = (0.054, 0.054, 0.052)
    largest = (0.066, 0.066, 0.064)
    round = True
    density = 700.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A cap on a stout stem."""
        radius, height = size[0] / 2, size[2]
        stem = [(0, 0), (0.52 * radius, 0), (0.5 * radius, 0.4 * height)]
        solid.show(css("#efe3d0"), revolve(stem))
        arc = [(0.5, 0.4), (0.9, 0.42), (1.0, 0.5), (0.94, 0.7), (0.66, 0.9), (0.3, 0.985), (0, 1)]
        cap = [(r * radius, z * height) for r, z in arc]
        solid.show(colour, revolve(cap))
        solid.cylinder(0.52 * radius, (0, 0, 0), (0, 0, 0.45 * height))
        solid.hull(revolve(cap, 18).vertices)
