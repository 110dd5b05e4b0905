from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("tray")
class Tray(Kind):
    name = "tray"
    category = "container"
    synonyms = (
        *("serving tray", "cutlery tray", "baking sheet", "cutting board", "board", "pan tray"),
        *("rack", "dish rack", "mat", "placemat", "rug", "towel", "napkin"),
    )
    colour = "#7c9a92"
    smallest = (0.220, 0.160, 0.026)
    largest = (0.250, 0.190, 0.032)
    container = True
    density = 600.0
    wall = 0.007

    def opening(self, size: Size) -> Opening:
        half = (size[0] / 2 - self.wall, size[1] / 2 - self.wall)
        return Opening(shape="box", half_extents=half, floor=0.006, rim=size[2], flat=True)

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A wide floor with a low rim, and a grip on either end."""
        x, y, half = size[0] / 2, size[1] / 2, size[2] / 2
        wall = self.wall / 2
        solid.box((x, y, 0.003), (0, 0, 0.003))
        solid.show(shade(colour, 1.25), box((x - 0.001, y - 0.001, 0.003), (0, 0, 0.003)))
        for side in (-1, 1):
            ends = ((wall, y, half), (side * (x - wall), 0, half))
            flanks = ((x - 2 * wall, wall, half), (0, side * (y - wall), half))
            for extents, centre in (ends, flanks):
                solid.box(extents, centre)
                solid.show(colour, box(extents, centre, bevel=0.0015))
            slot = box((wall + 0.0004, 0.2 * y, 0.25 * half), (side * (x - wall), 0, 1.2 * half))
            solid.show(shade(colour, 0.4), slot)
