from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import revolve
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("can")
class Can(Kind):
    name = "can"
    category = "can"
    synonyms = (
        "tin",
        "coke",
        "soda",
        "cola",
        "beer",
        "soup",
        "tuna",
        "bean",
        "spam",
        "energy drink",
    )
    colour = "#c6372f"
    smallest = (0.054, 0.054, 0.080)
    largest = (0.066, 0.066, 0.110)
    round = True
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A coloured label between two metal rims, a recessed lid, a light band."""
        width, _, height = size
        radius = width / 2
        solid.cylinder(radius, (0, 0, 0), (0, 0, height))
        label = 0.985 * radius
        solid.show(colour, revolve([(label, 0.05 * height), (label, 0.94 * height)]))
        band = label + 0.0004
        solid.show(shade(colour, 1.75), revolve([(band, 0.36 * height), (band, 0.62 * height)]))
        rim, lid = 0.9 * radius, height - 0.003
        bottom = [(0, 0), (0.94 * radius, 0), (radius, 0.003), (radius, 0.05 * height)]
        top = [(radius, 0.94 * height), (radius, height - 0.002), (0.95 * radius, height)]
        metal = css("#c9ccd1")
        solid.show(metal, revolve(bottom), revolve([*top, (rim, height), (rim, lid), (0, lid)]))
