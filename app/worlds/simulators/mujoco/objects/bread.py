import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, shade
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import Mesh, prism
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("bread")
class Bread(Kind):
    name = "bread"
    category = "food"
    synonyms = (
        "loaf",
        "loaf of bread",
        "toast",
        "bun",
        "baguette",
        "sandwich",
        "bagel",
        "croissant",
    )
    colour = "#c68642"
    smallest = (0.100, 0.052, 0.046)
    largest = (0.130, 0.066, 0.060)
    density = 300.0

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """A loaf with a round top and a lighter cut at one end."""
        long, wide, height = size[0] / 2, size[1] / 2, size[2]
        turns = np.linspace(0, np.pi, 9)
        arch = [(wide * np.cos(t), height * (0.55 + 0.45 * np.sin(t))) for t in turns]
        outline = [(0.9 * wide, 0.0), *arch, (-0.9 * wide, 0.0)]
        loaf = _along_x(prism(outline, -long, long))
        solid.show(colour, loaf)
        solid.hull(loaf.vertices)
        crumb = [(0.9 * y, 0.02 * height + 0.9 * z) for y, z in outline]
        solid.show(shade(colour, 1.7), _along_x(prism(crumb, long - 0.001, long + 0.0003)))


def _along_x(mesh: Mesh) -> Mesh:
    """From an outline over y and z with its thickness along z to a bar along x."""
    return Mesh(mesh.vertices[:, [2, 0, 1]], mesh.faces)
