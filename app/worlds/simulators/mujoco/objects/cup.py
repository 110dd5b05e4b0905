from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import revolve, ring_wedges
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("cup")
class Cup(Kind):
    name = "cup"
    category = "tableware"
    synonyms = (
        "glass",
        "tumbler",
        "beaker",
        "paper cup",
        "plastic cup",
        "pitcher",
        "jar",
        "goblet",
    )
    colour = "#e76f51"
    smallest = (0.068, 0.068, 0.085)
    largest = (0.074, 0.074, 0.100)
    round = True
    container = True
    density = 900.0

    def opening(self, size: Size) -> Opening:
        inside = size[0] / 2 - 0.004
        return Opening(shape="round", half_extents=(inside, inside), floor=0.006, rim=size[2])

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A tapered ring of wedges; no handle, a lighter inside."""
        radius, height = size[0] / 2, size[2]
        foot = 0.78 * radius
        inner, outer = [(foot - 0.004, 0), (radius - 0.004, height)], [(foot, 0), (radius, height)]
        for piece in ring_wedges(inner, outer):
            solid.hull(piece)
        solid.cylinder(foot - 0.004, (0, 0, 0), (0, 0, 0.006))
        lip = [
            (radius - 0.0006, height - 0.002),
            (radius, height - 0.001),
            (radius - 0.002, height),
        ]
        solid.show(colour, revolve([(0, 0), (foot, 0), *lip], segments=36))
        cavity = [(radius - 0.002, height), (radius - 0.004, height - 0.001), (foot - 0.003, 0.006)]
        solid.show(shade(colour, 1.5), revolve([*cavity, (0, 0.006)], segments=36))
