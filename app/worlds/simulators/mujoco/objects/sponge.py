from app.worlds.simulators.mujoco.colours import Colour, css, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, ellipsoid
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("sponge")
class Sponge(Kind):
    name = "sponge"
    category = "cleaning"
    synonyms = ("scrubber", "eraser", "soap", "bar of soap", "scouring pad", "cloth", "foam")
    colour = "#f4d35e"
    smallest = (0.090, 0.058, 0.030)
    largest = (0.110, 0.070, 0.038)
    density = 120.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Soft below, a green scouring layer on top, a few pores."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        solid.box((x, y, height / 2), (0, 0, height / 2))
        soft = 0.39 * height
        solid.show(colour, box((x, y, soft), (0, 0, soft), bevel=0.003))
        pad = (x, y, 0.11 * height)
        solid.show(css("#3f7d4e"), box(pad, (0, 0, 0.89 * height), bevel=0.0015))
        pores = []
        for index in range(28):
            along, up = (0.618 * index) % 1 * 1.8 - 0.9, (0.37 * index) % 1 * 1.4 + 0.3
            side = 1 if index % 2 else -1
            pore = ellipsoid((0.003, 0.0006, 0.002), rings=5)
            pores.append(pore.moved(along * x, side * (y - 0.0004), up * soft))
        solid.show(shade(colour, 0.75), *pores)
