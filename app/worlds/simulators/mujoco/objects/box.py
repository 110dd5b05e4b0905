from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("box")
class Box(Kind):
    """Open at the top; a closed one is a cracker box."""

    name = "box"
    category = "container"
    synonyms = (
        *(
            "open box",
            "crate",
            "chest",
            "shelf",
            "toolbox",
            "tool box",
            "toy box",
            "case",
        ),
        *("cardboard box", "container", "cooler", "cradle", "cabinet", "lunch box", "shoe box"),
    )
    colour = "#b98a56"
    smallest = (0.170, 0.140, 0.060)
    largest = (0.200, 0.170, 0.080)
    container = True
    density = 550.0
    wall = 0.007

    def opening(self, size: Size) -> Opening:
        half = (size[0] / 2 - self.wall, size[1] / 2 - self.wall)
        return Opening(shape="box", half_extents=half, floor=self.wall, rim=size[2])

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A floor and four walls; the inside is a little darker."""
        x, y, half = size[0] / 2, size[1] / 2, size[2] / 2
        wall = self.wall / 2
        solid.box((x, y, wall), (0, 0, wall))
        solid.show(shade(colour, 0.75), box((x - 0.001, y - 0.001, wall), (0, 0, wall)))
        for side in (-1, 1):
            ends = ((wall, y, half), (side * (x - wall), 0, half))
            flanks = ((x - 2 * wall, wall, half), (0, side * (y - wall), half))
            for extents, centre in (ends, flanks):
                solid.box(extents, centre)
                solid.show(colour, box(extents, centre, bevel=0.0012))
