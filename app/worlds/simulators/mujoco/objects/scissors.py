import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import hull, revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("scissors")
class Scissors(Kind):
    name = "scissors"
    category = "tool"
    synonyms = ("scissor", "shears", "shear", "tongs", "tong")
    colour = "#d1433f"
    smallest = (0.150, 0.062, 0.014)
    largest = (0.175, 0.070, 0.017)
    density = 1200.0

    def grip(self, size: Size) -> float:
        return 0.5 * size[1]  # across both blades, at the pivot

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Two blades a little open, a pivot, two rings to put fingers in."""
        length, width, height = size
        front, thick = length / 2, height / 2
        steel, x = css("#c6cad0"), -0.08 * length
        for side in (-1, 1):
            blade = [(x, side * 0.02), (x, side * 0.25), (front, side * 0.12), (front, side * 0.08)]
            flat = np.array([(a, b * width) for a, b in blade])
            corners = np.array([(a, b, z) for a, b in flat for z in (0.0, thick)])
            solid.hull(corners)
            solid.show(steel, hull(corners).faceted())
            radius = width / 4
            centre = np.array([radius - front, side * (width / 2 - radius), height / 2])
            turn = np.linspace(0, 2 * np.pi, 29)
            loop = np.column_stack([np.cos(turn), 0.95 * np.sin(turn), 0 * turn])
            bow = height / 2 - 0.0005
            solid.show(colour, tube((radius - bow) * loop + centre, np.full(29, bow), 10))
            solid.cylinder(radius, (*centre[:2], 0.0), (*centre[:2], height))
            arm = [(1.6 * radius - front, side * 0.3 * width, bow), (x, -side * 0.06 * width, bow)]
            solid.show(colour, tube(arm, [bow, 0.9 * bow], 10))
            solid.capsule(0.9 * bow, *arm)
        pivot = revolve([(0, 0), (0.004, 0), (0.004, 0.75 * height), (0, 0.75 * height)], 12)
        solid.show(css("#6f757c"), pivot.moved(x + 0.05 * length))
        solid.box((0.06 * length, 0.22 * width, 0.4 * height), (x + 0.03 * length, 0, 0.4 * height))
