from collections.abc import Sequence

import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Mesh, ellipsoid
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("teddy")
class Teddy(Kind):
    name = "teddy"
    category = "toy"
    synonyms = ("teddy bear", "bear", "doll", "plush", "stuffed animal", "soft toy", "toy")
    colour = "#a9743f"
    smallest = (0.100, 0.066, 0.050)
    largest = (0.120, 0.080, 0.058)
    density = 300.0

    def grip(self, size: Size) -> float:
        return 0.62 * size[1]  # around the belly, between the limbs

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its back along x: head, belly, four limbs, ears, a snout."""
        length, width, height = size
        scale = np.array([length, width, height])

        def lump(radii: Sequence[float], centre: Sequence[float]) -> Mesh:
            half, spot = scale * radii, scale * centre
            solid.ellipsoid(half.tolist(), spot.tolist())
            return ellipsoid(half.tolist(), spot.tolist(), rings=12)

        head = lump((0.18, 0.28, 0.44), (0.29, 0, 0.44))
        belly = lump((0.26, 0.31, 0.45), (-0.08, 0, 0.45))
        arms = [lump((0.08, 0.15, 0.2), (0.06, side * 0.35, 0.2)) for side in (-1, 1)]
        legs = [lump((0.13, 0.13, 0.22), (-0.37, side * 0.26, 0.22)) for side in (-1, 1)]
        solid.show(colour, head, belly, *arms, *legs)
        pale = shade(colour, 1.4)
        ears = [
            ellipsoid((0.006, 0.008, 0.006), scale * (0.43, side * 0.2, 0.5)) for side in (-1, 1)
        ]
        snout = ellipsoid((0.009, 0.009, 0.005), scale * (0.27, 0, 0.87))
        chest = ellipsoid((0.014, 0.012, 0.003), scale * (-0.06, 0, 0.88))
        solid.show(pale, *ears, snout, chest)
        eyes = [scale * (0.33, side * 0.1, 0.85) for side in (-1, 1)]
        dots = [ellipsoid((0.003, 0.003, 0.002), spot, rings=6) for spot in eyes]
        nose = ellipsoid((0.003, 0.004, 0.002), scale * (0.29, 0, 0.955), rings=6)
        solid.show(css("#1d1712"), *dots, nose)
