from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import ellipsoid, globe, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("apple")
class Apple(Kind):
    name = "apple"
    category = "fruit"
    synonyms = ("granny smith", "pink lady")
    colour = "#c8202f"
    smallest = (0.060, 0.060, 0.062)
    largest = (0.070, 0.070, 0.070)
    round = True
    density = 850.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        width, _, height = size
        flesh = 0.90 * height
        solid.ellipsoid((width / 2, width / 2, flesh / 2), (0, 0, flesh / 2))
        solid.show(colour, globe(width, flesh, dimple=0.10 * width))
        top = 0.82 * flesh
        stem = [(0, 0, top), (0, 0, 0.93 * height), (0.05 * width, 0, height - 0.002)]
        solid.show(css("#5b3a1e"), tube(stem, [0.0022, 0.0018, 0.0022], segments=8))
        leaf = ellipsoid((0.14 * width, 0.06 * width, 0.001)).turned("y", -0.3)
        solid.show(css("#4c8c2b"), leaf.moved(0.15 * width, 0, 0.93 * height))
