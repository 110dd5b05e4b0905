from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("salt_shaker")
class SaltShaker(Kind):
    name = "salt_shaker"
    category = "tableware"
    synonyms = (
        "salt",
        "shaker",
        "pepper shaker",
        "salt cellar",
        "pepper mill",
        "spice",
        "spice jar",
    )
    colour = "#d9e2ec"
    smallest = (0.040, 0.040, 0.070)
    largest = (0.050, 0.050, 0.090)
    round = True
    density = 800.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A glass foot under a metal dome with a few holes."""
        radius, height = size[0] / 2, size[2]
        neck = 0.68 * height
        flank = [(0, 0), (radius, 0), (radius, 0.004), (0.82 * radius, neck)]
        solid.show(colour, revolve(flank))
        dome = [(0.86, 0.68), (0.86, 0.86), (0.7, 0.95), (0.4, 0.99), (0.0, 1.0)]
        cap = [(r * radius, z * height) for r, z in dome]
        solid.show(css("#b6bac0"), revolve(cap))
        solid.cylinder(0.98 * radius, (0, 0, 0), (0, 0, 0.3 * height))
        solid.cylinder(0.88 * radius, (0, 0, 0.3 * height), (0, 0, neck))
        solid.hull(revolve(cap, 16).vertices)
