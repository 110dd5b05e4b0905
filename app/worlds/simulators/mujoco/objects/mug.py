import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.shapes import revolve, ring_wedges, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("mug")
class Mug(Kind):
    name = "mug"
    category = "tableware"
    synonyms = ("coffee mug", "coffee cup", "teacup", "tea cup", "stein")
    colour = "#3f8fa8"
    smallest = (0.092, 0.068, 0.080)
    largest = (0.098, 0.074, 0.092)
    container = True
    density = 1500.0

    def opening(self, size: Size) -> Opening:
        inside = size[1] / 2 - 0.004
        return Opening(shape="round", half_extents=(inside, inside), floor=0.006, rim=size[2])

    def half_extents(self, size: Size) -> tuple[float, float]:
        """The origin is on the axis of the mug; its handle reaches out along +x."""
        return size[0] - size[1] / 2, size[1] / 2

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A ring of wedges with a handle of capsules, white inside."""
        radius, height = size[1] / 2, size[2]
        inside, out = radius - 0.004, size[0] - size[1] / 2
        for piece in ring_wedges([(inside, 0), (inside, height)], [(radius, 0), (radius, height)]):
            solid.hull(piece)
        solid.cylinder(inside, (0, 0, 0), (0, 0, 0.006))
        outside = [(0, 0), (0.9 * radius, 0), (radius, 0.004), (radius, height - 0.001)]
        solid.show(colour, revolve([*outside, (radius - 0.001, height)], segments=36))
        cavity = [(radius - 0.001, height), (inside, height - 0.001), (inside, 0.006), (0, 0.006)]
        solid.show(css("#f5f3ec"), revolve(cavity, segments=36))
        bend = np.linspace(-1.25, 1.25, 9)
        bow = (np.cos(bend) - np.cos(1.25)) / (1 - np.cos(1.25))
        path = np.column_stack([radius - 0.003 + bow * (out - radius - 0.0015), 0 * bend, bend])
        path[:, 2] = height * (0.52 + 0.3 * np.sin(bend) / np.sin(1.25))
        solid.show(colour, tube(path, np.full(9, 0.0045)))
        for start, end in zip(path[:-1:2], path[2::2], strict=True):
            solid.capsule(0.0045, start, end)
