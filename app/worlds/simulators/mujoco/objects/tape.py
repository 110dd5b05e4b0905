from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve, ring_wedges
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("tape")
class Tape(Kind):
    name = "tape"
    category = "stationery"
    synonyms = (
        "duct tape",
        "scotch tape",
        "masking tape",
        "roll of tape",
        "tape roll",
        "roll",
        "reel",
    )
    colour = "#8b8f96"
    smallest = (0.060, 0.060, 0.024)
    largest = (0.070, 0.070, 0.032)
    round = True
    density = 700.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A roll lying flat, with a cardboard core; its hole is a hole."""
        radius, height = size[0] / 2, size[2]
        core, hole = 0.68 * radius, 0.62 * radius
        inner, outer = [(hole, 0), (hole, height)], [(radius, 0), (radius, height)]
        for piece in ring_wedges(inner, outer, sectors=12):
            solid.hull(piece)
        roll = [(core, 0), (radius, 0), (radius, height), (core, height)]
        solid.show(colour, revolve(roll, segments=36))
        card = [(core, height), (hole, height), (hole, 0), (core, 0)]
        solid.show(css("#c9a878"), revolve(card, segments=36))
