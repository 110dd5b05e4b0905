import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, ellipsoid, prism, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("toy_car")
class ToyCar(Kind):
    name = "toy_car"
    category = "toy"
    synonyms = ("car", "toy truck", "truck", "race car", "vehicle", "bus", "toy bus")
    colour = "#cf2e3a"
    smallest = (0.090, 0.046, 0.040)
    largest = (0.110, 0.054, 0.048)
    density = 500.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A body, a cabin with windows, four wheels that do not turn."""
        length, width, height = size
        x, y = length / 2, width / 2
        wheel = 0.19 * height
        body, cabin = (0.98 * x, 0.9 * y, 0.2 * height), (0.5 * x, 0.76 * y, 0.2 * height)
        low, high = (0, 0, 0.4 * height), (-0.1 * x, 0, 0.78 * height)
        solid.box((x, y, 0.3 * height), (0, 0, 0.3 * height))
        solid.box((cabin[0], cabin[1], 0.2 * height), (high[0], 0, 0.8 * height))
        roof = [(-0.55 * x, 0.6), (0.42 * x, 0.6), (0.2 * x, 1.0), (-0.42 * x, 1.0)]
        shell = prism([(a, b * height) for a, b in roof], -cabin[1], cabin[1])
        solid.show(colour, box(body, low, bevel=0.004), shell.turned("x", np.pi / 2))
        glass = [(-0.44 * x, 0.65), (0.32 * x, 0.65), (0.16 * x, 0.94), (-0.36 * x, 0.94)]
        panes = prism([(a, b * height) for a, b in glass], -cabin[1] - 0.0006, cabin[1] + 0.0006)
        screen = box((0.002, 0.8 * cabin[1], 0.12 * height)).turned("y", -0.5)
        solid.show(css("#26323f"), panes.turned("x", np.pi / 2))
        solid.show(css("#9cc3d9"), screen.moved(0.31 * x, 0, 0.79 * height))
        tyre = revolve([(0, -0.1), (0.9, -0.1), (1, -0.08), (1, 0.08), (0.9, 0.1), (0, 0.1)], 20)
        tyre = tyre.scaled(wheel, wheel, width).turned("x", np.pi / 2)
        corners = [(a * 0.6 * x, b * (y - 0.1 * width), wheel) for a in (-1, 1) for b in (-1, 1)]
        solid.show(css("#1d1f22"), *(tyre.moved(*corner) for corner in corners))
        hub = ellipsoid((0.5 * wheel, 0.002, 0.5 * wheel), rings=8)
        sides = [(a, np.sign(b) * (y - 0.0015), c) for a, b, c in corners]
        solid.show(css("#d5d8dc"), *(hub.moved(*side) for side in sides))
