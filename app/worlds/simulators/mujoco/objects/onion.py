import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("onion")
class Onion(Kind):
    name = "onion"
    category = "vegetable"
    synonyms = ("garlic", "shallot", "beet", "radish", "turnip")
    colour = "#b5713c"
    smallest = (0.056, 0.056, 0.062)
    largest = (0.068, 0.068, 0.074)
    round = True
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A bulb drawn to a point, with fine meridians and a flat root."""
        width, _, height = size
        outline = [(0, 0), (0.14, 0), (0.3, 0.06), (0.44, 0.18), (0.5, 0.34), (0.46, 0.52)]
        outline += [(0.34, 0.67), (0.18, 0.77), (0.08, 0.86), (0.05, 0.94), (0.06, 1), (0, 1)]
        profile = [(radius * width, z * height) for radius, z in outline]
        solid.show(colour, revolve(profile))
        solid.hull(revolve([profile[i] for i in (1, 2, 4, 6, 9)], segments=14).vertices)
        line = np.array([(radius + 0.0001, 0, z) for radius, z in profile[2:9]])
        streak = tube(line, np.full(7, 0.0006), 6)
        turns = (streak.turned("z", angle) for angle in np.arange(9) * 2 * np.pi / 9)
        solid.show(shade(colour, 0.7), *turns)
