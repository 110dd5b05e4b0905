from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("bottle")
class Bottle(Kind):
    name = "bottle"
    category = "bottle"
    synonyms = ("flask", "mustard", "ketchup", "shampoo", "wine", "detergent", "bleach cleanser")
    colour = "#2f8f5b"
    smallest = (0.052, 0.052, 0.150)
    largest = (0.064, 0.064, 0.190)
    round = True
    density = 550.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A body with a label, a shoulder, a neck and a screw cap."""
        width, _, height = size
        radius, neck = width / 2, max(0.011, 0.22 * width)
        low, high = 0.62 * height, 0.80 * height
        shoulder = [(0.93 * radius, low + 0.05 * height), (0.7 * radius, low + 0.11 * height)]
        foot = [(0, 0), (0.9 * radius, 0), (radius, 0.012)]
        solid.show(
            colour, revolve([*foot, (radius, low), *shoulder, (neck, high), (neck, 0.9 * height)])
        )
        cap = [(0, 0.86), (1.18, 0.86), (1.18, 0.99), (1.0, 1.0), (0, 1.0)]
        solid.show(shade(colour, 0.45), revolve([(r * neck, z * height) for r, z in cap]))
        label = [(radius + 0.0004, 0.18 * height), (radius + 0.0004, 0.48 * height)]
        solid.show(css("#f4f1e6"), revolve(label))
        solid.cylinder(radius, (0, 0, 0), (0, 0, low))
        solid.hull(revolve([(radius, low), *shoulder, (neck, high)], segments=14).vertices)
        solid.cylinder(1.18 * neck, (0, 0, high), (0, 0, height))
