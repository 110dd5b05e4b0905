import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("ball")
class Ball(Kind):
    name = "ball"
    category = "toy"
    synonyms = (
        *("tennis ball", "baseball", "golf ball", "marble", "sphere", "football", "basketball"),
        *("softball", "soccer ball", "racquetball"),
    )
    colour = "#e2602b"
    smallest = (0.046, 0.046, 0.046)
    largest = (0.064, 0.064, 0.064)
    round = True
    density = 500.0

    def draw_size(self, random: np.random.Generator) -> Size:
        side = super().draw_size(random)[0]
        return side, side, side

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A sphere, if its measures are equal, with two bands around it."""
        half = tuple(side / 2 for side in size)
        solid.ellipsoid(half, (0, 0, half[2]))
        solid.show(colour, ellipsoid(half, (0, 0, half[2]), rings=18))
        around = np.linspace(-0.08, 0.08, 5)
        rim = list(zip(np.cos(around).tolist(), np.sin(around).tolist(), strict=True))
        band = revolve(rim, 40).scaled(*(1.004 * side for side in half)).turned("x", np.pi / 2)
        bands = (band.turned("z", turn).moved(0, 0, half[2]) for turn in (0.0, np.pi / 2))
        solid.show(css("#fbf6ea"), *bands)
