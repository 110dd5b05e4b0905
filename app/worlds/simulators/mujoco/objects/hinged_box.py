from app.worlds.simulators.mujoco.articulation import Articulation
from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid

FIN, LID, WALL = 0.030, 0.006, 0.006
"""How high the handle stands on the lid, and how thick that and the walls are [m]."""
TRAVEL = 1.68
"""How far the lid opens [rad]."""


@kinds.register("hinged_box")
class HingedBox(Kind):
    """A box with a lid hinged at its back; its size is that with the lid shut."""

    name = "hinged_box"
    category = "furniture"
    synonyms = ("lidded box", "jewelry box", "jewellery box", "treasure chest")
    colour = "#7f5539"
    smallest = (0.150, 0.140, 0.086)
    largest = (0.170, 0.160, 0.096)
    container = True
    faces = True
    density = 3500.0
    part_density = 500.0

    def opening(self, size: Size) -> Opening:
        half = (size[0] / 2 - WALL, size[1] / 2 - WALL)
        return Opening(shape="box", half_extents=half, floor=WALL, rim=size[2] - FIN - LID)

    def half_extents(self, size: Size) -> tuple[float, float]:
        """With room behind for the lid when it is open."""
        return size[0] / 2 + FIN + LID + 0.02, size[1] / 2

    def articulation(self, size: Size) -> Articulation:
        rim = size[2] - FIN - LID
        return Articulation(
            joint="hinge",
            axis=(0.0, 1.0, 0.0),
            pivot=(size[0] / 2, 0.0, rim),
            travel=TRAVEL,
            handle=(-size[0] / 2 + 0.016, 0.0, size[2] - 0.013),
            thickness=0.012,
            friction=0.12,
        )

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A floor and four walls."""
        x, y, half = size[0] / 2, size[1] / 2, (size[2] - FIN - LID) / 2
        wall = WALL / 2
        solid.box((x, y, wall), (0, 0, wall))
        solid.show(shade(colour, 0.75), box((x - 0.001, y - 0.001, wall), (0, 0, wall)))
        for side in (-1, 1):
            ends = ((wall, y, half), (side * (x - wall), 0, half))
            flanks = ((x - 2 * wall, wall, half), (0, side * (y - wall), half))
            for extents, centre in (ends, flanks):
                solid.box(extents, centre)
                solid.show(colour, box(extents, centre, bevel=0.001))

    def build_part(self, solid: Solid, size: Size, colour: Colour) -> None:
        """The lid, with a fin to lift it by; its frame is on the hinge."""
        plate = ((size[0] / 2, size[1] / 2, LID / 2), (-size[0] / 2, 0, LID / 2))
        solid.box(*plate)
        solid.show(shade(colour, 1.2), box(*plate, bevel=0.001))
        fin = ((0.016, 0.006, FIN / 2), (-size[0] + 0.016, 0, LID + FIN / 2))
        solid.box(*fin)
        solid.show(css("#c9a227"), box(*fin, bevel=0.002))
