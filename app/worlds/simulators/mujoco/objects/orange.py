from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import globe, prism, star
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("orange")
class Orange(Kind):
    name = "orange"
    category = "fruit"
    synonyms = ("mandarin", "tangerine", "clementine", "grapefruit", "satsuma")
    colour = "#f08a1d"
    smallest = (0.062, 0.062, 0.058)
    largest = (0.072, 0.072, 0.068)
    round = True
    density = 900.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        width, _, height = size
        solid.ellipsoid((width / 2, width / 2, height / 2), (0, 0, height / 2))
        solid.show(colour, globe(width, height, dimple=0.02 * width))
        navel = prism(star(5, 0.0025, 0.005), -0.0012, 0.0)
        solid.show(css("#5d7a2c"), navel.moved(0, 0, height))
