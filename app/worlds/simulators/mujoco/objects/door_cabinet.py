from app.worlds.simulators.mujoco.articulation import Articulation
from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid

FIN, DOOR, WALL = 0.034, 0.008, 0.006
"""How far the handle stands out, how thick the door and the other walls are [m]."""
TRAVEL = 1.5
"""How far the door opens [rad]."""


@kinds.register("door_cabinet")
class DoorCabinet(Kind):
    """A small cabinet with a door hinged on the robot's right; its size is that with it shut."""

    name = "door_cabinet"
    category = "furniture"
    synonyms = ("cabinet door", "locker", "medicine cabinet")
    colour = "#8a9a8e"
    smallest = (0.130, 0.120, 0.130)
    largest = (0.140, 0.130, 0.150)
    container = True
    faces = True
    density = 2200.0
    part_density = 500.0

    def opening(self, size: Size) -> Opening:
        """Its inside, which is reached from the front only."""
        half = ((size[0] - FIN - DOOR) / 2 - WALL, size[1] / 2 - WALL)
        return Opening(shape="box", half_extents=half, floor=WALL, rim=size[2] - WALL)

    def half_extents(self, size: Size) -> tuple[float, float]:
        """With room in front for the open door and the hand that moves it."""
        return (size[0] - FIN) / 2 + size[1] + 0.09, size[1] / 2 + 0.01

    def articulation(self, size: Size) -> Articulation:
        front = -(size[0] - FIN - DOOR) / 2
        return Articulation(
            joint="hinge",
            axis=(0.0, 0.0, 1.0),
            pivot=(front, -size[1] / 2, 0.0),
            travel=TRAVEL,
            handle=(front - DOOR - 0.6 * FIN, size[1] / 2 - 0.03, size[2] - 0.018),
            thickness=0.012,
            friction=0.05,
        )

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A floor, a top, two sides and a back, open in front."""
        deep, wide, height = (size[0] - FIN - DOOR) / 2, size[1] / 2, size[2]
        wall = WALL / 2
        for half, centre in (
            ((deep, wide, wall), (0, 0, wall)),
            ((deep, wide, wall), (0, 0, height - wall)),
            ((wall, wide - WALL, height / 2 - WALL), (deep - wall, 0, height / 2)),
            *(
                ((deep, wall, height / 2 - WALL), (0, side * (wide - wall), height / 2))
                for side in (-1, 1)
            ),
        ):
            solid.box(half, centre)
            solid.show(colour, box(half, centre, bevel=0.001))

    def build_part(self, solid: Solid, size: Size, colour: Colour) -> None:
        """The door, with a fin to pull it by; its frame is on the hinge."""
        wide, height = size[1] / 2, size[2] / 2
        door = ((DOOR / 2, wide, height - 0.002), (-DOOR / 2, wide, height))
        solid.box(*door)
        solid.show(shade(colour, 1.25), box(*door, bevel=0.001))
        fin = ((FIN / 2, 0.006, 0.018), (-DOOR - FIN / 2, size[1] - 0.03, size[2] - 0.018))
        solid.box(*fin)
        solid.show(css("#4a4e52"), box(*fin, bevel=0.002))
