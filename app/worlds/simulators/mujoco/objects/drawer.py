from app.worlds.simulators.mujoco.articulation import Articulation
from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid

FIN, TRAVEL = 0.034, 0.105
"""How far the handle stands out, and how far the drawer comes out [m]."""
WALL, PLAY = 0.006, 0.002


@kinds.register("drawer")
class Drawer(Kind):
    """A low chest with one drawer; its size is that with the drawer out."""

    name = "drawer"
    category = "furniture"
    synonyms = ("drawers", "desk drawer")
    colour = "#b08968"
    smallest = (0.270, 0.128, 0.072)
    largest = (0.290, 0.138, 0.080)
    container = True
    faces = True
    density = 3000.0

    def opening(self, size: Size) -> Opening:
        half = _tray(size)
        inside = (half[0] - WALL, half[1] - WALL)
        return Opening(shape="box", half_extents=inside, floor=WALL + PLAY + 0.004, rim=half[2])

    def half_extents(self, size: Size) -> tuple[float, float]:
        """With room in front for the hand that pulls it."""
        return size[0] / 2 + 0.045, size[1] / 2

    def articulation(self, size: Size) -> Articulation:
        front = size[0] / 2 - _depth(size)
        return Articulation(
            joint="slide",
            axis=(-1.0, 0.0, 0.0),
            pivot=(front + _tray(size)[0], 0.0, 0.0),
            travel=TRAVEL,
            handle=(front - 0.6 * FIN, 0.0, size[2] - 0.018),
            thickness=0.012,
            friction=1.0,
            holds=True,
        )

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """The chest: a floor, a top, two sides and a back, open in front."""
        depth, wide, height = _depth(size), size[1] / 2, size[2]
        middle, wall = size[0] / 2 - depth / 2, WALL / 2
        for half, centre in (
            ((depth / 2, wide, wall), (middle, 0, wall)),
            ((depth / 2, wide, wall), (middle, 0, height - wall)),
            ((wall, wide - WALL, height / 2 - WALL), (size[0] / 2 - wall, 0, height / 2)),
            *(
                ((depth / 2, wall, height / 2 - WALL), (middle, side * (wide - wall), height / 2))
                for side in (-1, 1)
            ),
        ):
            solid.box(half, centre)
            solid.show(colour, box(half, centre, bevel=0.0008))

    def build_part(self, solid: Solid, size: Size, colour: Colour) -> None:
        """The drawer: a tray with a front and a fin to pull it by."""
        long, wide, top = _tray(size)
        low, wall = WALL + PLAY, WALL / 2
        middle, half = (low + top) / 2, (top - low) / 2
        pieces = [((long, wide, 0.002), (0, 0, low + 0.002))]
        pieces += [((wall, wide, half), (side * (long - wall), 0, middle)) for side in (-1, 1)]
        pieces += [((long, wall, half), (0, side * (wide - wall), middle)) for side in (-1, 1)]
        for extents, centre in pieces:
            solid.box(extents, centre)
            solid.show(shade(colour, 1.25), box(extents, centre, bevel=0.0008))
        fin = ((FIN / 2, 0.006, 0.018), (-long - FIN / 2, 0, size[2] - 0.018))
        solid.box(*fin)
        solid.show(css("#5b6066"), box(*fin, bevel=0.002))


def _depth(size: Size) -> float:
    """Of the chest [m]."""
    return size[0] - FIN - TRAVEL


def _tray(size: Size) -> tuple[float, float, float]:
    """Half the length and width of the drawer outside, and the height of its rim [m]."""
    return (_depth(size) - WALL) / 2, size[1] / 2 - WALL - PLAY, size[2] - WALL - PLAY
