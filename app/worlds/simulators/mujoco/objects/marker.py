import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Mesh, box, lying, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("marker")
class Marker(Kind):
    name = "marker"
    category = "stationery"
    synonyms = ("highlighter", "felt pen", "sharpie", "crayon", "chalk", "glue stick", "lipstick")
    colour = "#2a62c9"
    smallest = (0.120, 0.018, 0.018)
    largest = (0.140, 0.022, 0.022)
    density = 600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A white barrel between a coloured cap with a clip and a coloured end."""
        length, width, height = size
        solid.hull(lying([(0.5, 0), (0.5, 1)], 10).fitted(size).vertices)
        barrel = [(0.46, 0.08), (0.46, 0.62)]
        cap = [(0, 1.0), (0.4, 1.0), (0.44, 0.98), (0.49, 0.62), (0.49, 0.6), (0.4, 0.6)][::-1]
        end = [(0, 0), (0.38, 0), (0.46, 0.02), (0.46, 0.08)]

        def laid(outline: list[tuple[float, float]]) -> Mesh:
            body = revolve(outline, 20).turned("y", np.pi / 2).moved(-0.5)
            return body.scaled(length, width, height).moved(0, 0, height / 2)

        solid.show(css("#f2f2ef"), laid(barrel))
        clip = box((0.14 * length, 0.1 * width, 0.03 * height), (0.3 * length, 0, 0.97 * height))
        solid.show(colour, laid(cap), laid(end), clip)
