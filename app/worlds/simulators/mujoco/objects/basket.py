import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import revolve, ring_wedges, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("basket")
class Basket(Kind):
    name = "basket"
    category = "container"
    synonyms = ("hamper", "laundry basket", "fruit basket", "picnic basket", "nest", "pouch", "bag")
    colour = "#c89b5b"
    smallest = (0.180, 0.180, 0.070)
    largest = (0.210, 0.210, 0.085)
    round = True
    container = True
    density = 400.0

    def opening(self, size: Size) -> Opening:
        inside = size[0] / 2 - 0.010
        return Opening(shape="round", half_extents=(inside, inside), floor=0.008, rim=size[2])

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Wicker: stacked rings woven around uprights, over one ring of wedges."""
        radius, height = size[0] / 2, size[2]
        foot, wall = 0.78 * radius, 0.009
        inner = [(foot - wall, 0), (radius - wall, height)]
        for piece in ring_wedges(inner, [(foot, 0), (radius, height)]):
            solid.hull(piece)
        solid.cylinder(foot - wall, (0, 0, 0), (0, 0, 0.008))
        rows = 9
        thick = height / rows / 2
        turn = np.linspace(0, 2 * np.pi, 65)
        for row in range(rows):
            z = (2 * row + 1) * thick
            middle = foot + (radius - foot) * z / height - wall / 2
            weave = middle + 0.0016 * np.cos(16 * turn + row * np.pi)
            weave = np.minimum(weave, radius - thick)
            ring = np.column_stack([weave * np.cos(turn), weave * np.sin(turn), 0 * turn + z])
            tone = colour if row % 2 else shade(colour, 0.82)
            solid.show(tone, tube(ring, np.full(65, thick), segments=6))
        solid.show(shade(colour, 0.6), revolve([(0, 0), (foot - 0.004, 0.001), (0, 0.008)], 36))
