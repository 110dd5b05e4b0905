from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("pear")
class Pear(Kind):
    name = "pear"
    category = "fruit"
    colour = "#b9c23a"
    smallest = (0.056, 0.056, 0.090)
    largest = (0.064, 0.064, 0.100)
    round = True
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Stands on a flattened bottom; bulb and neck collide as one hull."""
        width, _, height = size
        outline = [(0, 0), (0.22, 0), (0.38, 0.06), (0.48, 0.18), (0.5, 0.3), (0.46, 0.44)]
        outline += [(0.36, 0.58), (0.25, 0.72), (0.19, 0.82), (0.12, 0.88), (0, 0.9)]
        profile = [(radius * width, z * height) for radius, z in outline]
        solid.show(colour, revolve(profile))
        stem = [(0, 0, 0.88 * height), (0.03 * width, 0, height)]
        solid.show(css("#5b3a1e"), tube(stem, [0.0026, 0.002], segments=8))
        solid.hull(revolve([*profile[:6], profile[7], profile[9]], segments=14).vertices)
