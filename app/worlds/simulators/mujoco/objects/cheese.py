from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, prism
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("cheese")
class Cheese(Kind):
    name = "cheese"
    category = "food"
    synonyms = ("cheese wedge", "cheddar", "gouda", "slice of cheese", "cake", "pie")
    colour = "#f2c14e"
    smallest = (0.080, 0.050, 0.034)
    largest = (0.100, 0.060, 0.044)
    density = 700.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A wedge with a few holes in its sides."""
        long, wide, height = size[0] / 2, size[1] / 2, size[2]
        outline = [(-long, -wide), (long, -0.1 * wide), (long, 0.1 * wide), (-long, wide)]
        solid.show(colour, prism(outline, 0.0, height))
        solid.hull(prism(outline, 0.0, height).vertices)
        hole = ellipsoid((0.001, 0.006, 0.005), rings=6)
        for side, up in ((-0.5, 0.4), (0.3, 0.65), (0.6, 0.3)):
            solid.show(shade(colour, 0.8), hole.moved(-long + 0.0004, side * wide, up * height))
