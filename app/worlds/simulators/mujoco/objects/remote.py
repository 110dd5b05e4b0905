from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("remote")
class Remote(Kind):
    name = "remote"
    category = "electronics"
    synonyms = (
        "remote control",
        "tv remote",
        "controller",
        "phone",
        "smartphone",
        "cell phone",
        "mobile phone",
    )
    colour = "#26282c"
    smallest = (0.140, 0.042, 0.020)
    largest = (0.170, 0.052, 0.024)
    density = 500.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A flat bar with rows of buttons."""
        x, y, half = (side / 2 for side in size)
        solid.box((x, y, half), (0, 0, half))
        solid.show(colour, box((x, y, half), (0, 0, half - 0.0004), bevel=0.003))
        keys = [
            box((0.05 * x, 0.16 * y, 0.0006), (along * x, side * y, 2 * half - 0.0005))
            for along in (-0.7, -0.5, -0.3, -0.1, 0.1)
            for side in (-0.5, 0.0, 0.5)
        ]
        solid.show(css("#b9bdc4"), *keys)
        solid.show(
            css("#c8352f"), box((0.05 * x, 0.2 * y, 0.0006), (0.75 * x, 0, 2 * half - 0.0005))
        )
