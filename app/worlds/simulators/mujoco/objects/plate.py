from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import revolve, ring_wedges
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("plate")
class Plate(Kind):
    name = "plate"
    category = "tableware"
    synonyms = ("saucer", "platter", "dinner plate", "charging pad", "coaster")
    colour = "#f1ede2"
    smallest = (0.190, 0.190, 0.018)
    largest = (0.220, 0.220, 0.020)
    round = True
    container = True
    density = 1400.0

    def opening(self, size: Size) -> Opening:
        inside = size[0] / 2 - 0.002
        half = (inside, inside)
        return Opening(shape="round", half_extents=half, floor=0.005, rim=size[2], flat=True)

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A flat middle and one ring of wedges, with a thin line along the brim."""
        radius, height = size[0] / 2, size[2]
        foot = 0.70 * radius
        inner = [(foot, 0.005), (radius - 0.002, height)]
        outer = [(foot + 0.004, 0.0), (radius, height - 0.005)]
        for piece in ring_wedges(inner, outer):
            solid.hull(piece)
        solid.cylinder(foot + 0.002, (0, 0, 0), (0, 0, 0.005))
        solid.show(colour, revolve([(0, 0), *outer, *inner[::-1], (0, 0.005)], segments=44))
        slope = (height - 0.005) / (radius - 0.002 - foot)
        edges = [(r, 0.0054 + slope * (r - foot)) for r in (radius - 0.007, radius - 0.004)]
        solid.show(css("#5b7fa6"), revolve(edges[::-1], segments=44))
