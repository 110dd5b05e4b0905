from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import revolve, ring_wedges
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("bowl")
class Bowl(Kind):
    name = "bowl"
    category = "tableware"
    synonyms = ("dish", "pan", "pot", "saucepan", "frying pan", "skillet", "colander", "sink")
    colour = "#b9d3e8"
    smallest = (0.160, 0.160, 0.052)
    largest = (0.190, 0.190, 0.062)
    round = True
    container = True
    density = 900.0

    def opening(self, size: Size) -> Opening:
        inside = size[0] / 2 - 0.005
        return Opening(shape="round", half_extents=(inside, inside), floor=0.006, rim=size[2])

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Two rings of wedges under a smooth shell."""
        radius, height = size[0] / 2, size[2]
        foot, brim = 0.52 * radius, radius - 0.005
        middle = foot + 0.65 * (radius - foot)
        inner = [(foot, 0.006), (middle - 0.004, 0.42 * height), (brim, height)]
        outer = [(foot + 0.003, 0.0), (middle + 0.002, 0.36 * height), (radius, height - 0.002)]
        for piece in ring_wedges(inner, outer):
            solid.hull(piece)
        solid.cylinder(foot + 0.001, (0, 0, 0), (0, 0, 0.006))
        solid.show(colour, revolve([(0, 0), *outer, *inner[::-1], (0, 0.006)], segments=40))
