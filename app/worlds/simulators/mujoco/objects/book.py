from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("book")
class Book(Kind):
    name = "book"
    category = "stationery"
    synonyms = ("notebook", "novel", "magazine", "newspaper", "diary", "notepad", "dictionary")
    colour = "#34567d"
    smallest = (0.100, 0.062, 0.020)
    largest = (0.125, 0.072, 0.030)
    density = 600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A pocket book lying flat: two covers, a spine, pages, a title plate."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        solid.box((x, y, height / 2), (0, 0, height / 2))
        cover = (x, y, 0.0015)
        solid.show(colour, box(cover, (0, 0, 0.0015)), box(cover, (0, 0, height - 0.0015)))
        solid.show(colour, box((x, 0.0015, height / 2), (0, 0.0015 - y, height / 2)))
        pages = (x - 0.003, y - 0.003, height / 2 - 0.0025)
        solid.show(css("#f3ead7"), box(pages, (0, 0, height / 2)))
        plate = box((0.5 * x, 0.28 * y, 0.0003), (0, 0.2 * y, height - 0.0001))
        solid.show(css("#e6c069"), plate.moved(0, 0, -0.0002))
