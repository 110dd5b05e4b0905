import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Points, box, revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("screwdriver")
class Screwdriver(Kind):
    name = "screwdriver"
    category = "tool"
    synonyms = ("screw driver", "chisel", "awl", "file", "soldering iron", "torch", "flashlight")
    colour = "#e1a11b"
    smallest = (0.170, 0.026, 0.026)
    largest = (0.200, 0.031, 0.031)
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A fluted handle that lies flat, and a thin shaft along its axis."""
        length, width, height = size

        def flutes(points: Points) -> Points:
            turn = np.arctan2(points[:, 2], points[:, 1])
            dent = 1 - 0.05 * (1 + np.cos(8 * turn)) * (np.abs(points[:, 0] - 0.22) < 0.14)
            return points * np.column_stack([np.ones(len(points)), dent, dent])

        outline = [(0, 0), (0.36, 0.005), (0.46, 0.03), (0.5, 0.08), (0.5, 0.34)]
        outline += [(0.36, 0.4), (0.36, 0.44), (0.2, 0.47), (0, 0.47)]
        grip = revolve(outline, 32).turned("y", np.pi / 2).bent(flutes)
        solid.show(colour, grip.moved(-0.5).scaled(length, width, height).moved(0, 0, height / 2))
        coarse = revolve(outline[2:6:1], 12).turned("y", np.pi / 2).turned("x", np.pi / 12)
        stretched = coarse.moved(-0.5).scaled(length, width, height / np.cos(np.pi / 12))
        solid.hull(stretched.moved(0, 0, height / 2).vertices)
        ends = [(-0.04 * length, 0, height / 2), (0.496 * length, 0, height / 2)]
        solid.show(css("#b9bdc3"), tube(ends, [0.0032, 0.0032], 12))
        blade = box((0.02 * length, 0.0042, 0.0012), (0.48 * length, 0, height / 2))
        solid.show(css("#8f949a"), blade)
        solid.capsule(0.0032, ends[0], (0.48 * length, 0, height / 2))
