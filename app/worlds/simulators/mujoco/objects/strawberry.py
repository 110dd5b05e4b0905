import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, lying, prism, star, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("strawberry")
class Strawberry(Kind):
    name = "strawberry"
    category = "fruit"
    synonyms = ("berry", "raspberry")
    colour = "#d3202b"
    smallest = (0.038, 0.032, 0.032)
    largest = (0.046, 0.038, 0.038)
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies along x, the leaves behind, the tip ahead; the seeds stand out a little."""
        length, width, height = size
        outline = [(0, 0), (0.3, 0.0), (0.45, 0.08), (0.5, 0.22), (0.47, 0.4)]
        outline += [(0.38, 0.6), (0.25, 0.8), (0.12, 0.94), (0, 1)]
        flesh = (0.92 * length, width, height)
        solid.show(colour, lying(outline).fitted(flesh).moved(0.04 * length))
        solid.hull(lying(outline, 12).fitted(flesh).moved(0.04 * length).vertices)
        seed = ellipsoid((0.0016, 0.0009, 0.0009), rings=4)
        seeds = [
            seed.moved(
                (0.92 * along - 0.42) * length,
                radius * width / 2 * np.cos(angle),
                radius * height / 2 * (0.96 * np.sin(angle) + 1),
            )
            for along, radius in ((0.18, 0.94), (0.36, 0.98), (0.54, 0.83), (0.72, 0.6))
            for angle in np.arange(8) * np.pi / 4 + 8 * along
        ]
        solid.show(css("#f3d36b"), *seeds)
        leaves = prism(star(6, 0.14 * width, 0.42 * width), -0.001, 0.001).turned("y", np.pi / 2)
        stem = tube([(0, 0, 0), (-0.07 * length, 0, 0.001)], [0.0018, 0.0015], segments=8)
        leaves, stem = (part.moved(-0.43 * length, 0, 0.46 * height) for part in (leaves, stem))
        solid.show(css("#4c9a2a"), leaves, stem)
