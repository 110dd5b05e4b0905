import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("camera")
class PhotoCamera(Kind):
    name = "camera"
    category = "electronics"
    synonyms = ("photo camera", "digital camera", "webcam")
    colour = "#2f3237"
    smallest = (0.090, 0.046, 0.060)
    largest = (0.110, 0.056, 0.074)
    density = 500.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A body with a lens in front, a finder and a button."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        deep, body = 0.62 * y, 0.88 * height
        middle = y - deep
        solid.box((x, deep, body / 2), (0, middle, body / 2))
        solid.show(colour, box((x, deep, body / 2), (0, middle, body / 2), bevel=0.003))
        radius, front = 0.40 * body, 2 * (y - deep)
        lens = [
            (0, 0),
            (radius, 0),
            (radius, front),
            (0.7 * radius, front),
            (0.6 * radius, 0.7 * front),
        ]
        barrel = revolve([*lens, (0, 0.7 * front)]).turned("x", np.pi / 2)
        solid.show(css("#54585e"), barrel.moved(0.1 * x, middle - deep, body / 2))
        start = (0.1 * x, middle - deep, body / 2)
        solid.cylinder(radius, start, (0.1 * x, -y, body / 2))
        finder = ((0.3 * x, 0.5 * deep, 0.06 * height), (0, middle, 0.94 * height))
        solid.box(*finder)
        solid.show(colour, box(*finder, bevel=0.001))
