from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("bin")
class Bin(Kind):
    name = "bin"
    category = "container"
    synonyms = (
        *("trash can", "garbage can", "trash", "wastebasket", "waste basket", "recycling bin"),
        *(
            "bucket",
            "pail",
            "trash bin",
            "rubbish",
            "waste bin",
            "tub",
            "hopper",
            "washing machine",
        ),
    )
    colour = "#5a6b7b"
    smallest = (0.170, 0.150, 0.090)
    largest = (0.200, 0.180, 0.110)
    container = True
    density = 450.0
    wall = 0.006

    def opening(self, size: Size) -> Opening:
        half = (size[0] / 2 - self.wall - 0.004, size[1] / 2 - self.wall - 0.004)
        return Opening(shape="box", half_extents=half, floor=self.wall, rim=size[2])

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A plastic tub: four walls under a turned-out rim, a floor, a light label in front."""
        x, y, height = size[0] / 2 - 0.004, size[1] / 2 - 0.004, size[2]
        half, wall = height / 2, self.wall / 2
        solid.box((x, y, wall), (0, 0, wall))
        solid.show(shade(colour, 0.7), box((x - 0.001, y - 0.001, wall), (0, 0, wall)))
        for side in (-1, 1):
            ends = ((wall, y, half), (side * (x - wall), 0, half))
            flanks = ((x - 2 * wall, wall, half), (0, side * (y - wall), half))
            for extents, centre in (ends, flanks):
                solid.box(extents, centre)
                solid.show(colour, box(extents, centre))
            long = ((x + 0.004, 0.004, 0.005), (0, side * y, height - 0.005))
            short = ((0.004, y - 0.004, 0.005), (side * x, 0, height - 0.005))
            solid.show(shade(colour, 0.8), box(*long, bevel=0.0015), box(*short, bevel=0.0015))
        solid.show(shade(colour, 1.7), box((0.3 * x, 0.0004, 0.2 * height), (0, -y, 0.5 * height)))
