import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Mesh, box, prism
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("stapler")
class Stapler(Kind):
    name = "stapler"
    category = "stationery"
    synonyms = ("staple gun", "hole punch", "puncher")
    colour = "#9b2226"
    smallest = (0.110, 0.032, 0.044)
    largest = (0.130, 0.038, 0.056)
    density = 600.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A foot, and an arm that rises to the back."""
        x, y, height = size[0] / 2, size[1] / 2, size[2]
        foot = ((x, y, 0.1 * height), (0, 0, 0.1 * height))
        solid.box(*foot)
        solid.show(css("#3a3d42"), box(*foot, bevel=0.002))
        outline = [
            (-x, 0.2),
            (0.9 * x, 0.36),
            (0.9 * x, 0.62),
            (0.5 * x, 0.8),
            (-0.8 * x, 1.0),
            (-x, 0.9),
        ]
        arm = prism([(along, up * height) for along, up in outline], -0.82 * y, 0.82 * y)
        arm = Mesh(arm.vertices[:, [0, 2, 1]] * np.array([1, -1, 1]), arm.faces)
        solid.show(colour, arm)
        solid.hull(arm.vertices)
