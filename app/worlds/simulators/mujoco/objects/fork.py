from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("fork")
class Fork(Kind):
    name = "fork"
    category = "cutlery"
    colour = "#c2c6cc"
    smallest = (0.165, 0.026, 0.015)
    largest = (0.190, 0.030, 0.018)
    density = 2500.0

    def grip(self, size: Size) -> float:
        return min(0.013, 0.5 * size[1])  # across the handle

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Four tines on a head, and a handle that its thick end holds up."""
        length, width, height = size
        half, back, thick = self.grip(size) / 2, -length / 2, 0.0022
        stem = ((0.34 * length, half, 0.0035), (back + 0.34 * length, 0, height - 0.0035))
        foot = ((0.035 * length, half, height / 2), (back + 0.035 * length, 0, height / 2))
        for part in (stem, foot):
            solid.box(*part)
            solid.show(colour, box(*part, bevel=0.0022))
        neck = [(back + 0.67 * length, 0, height - 0.004), (0.27 * length, 0, 2 * thick)]
        solid.show(colour, tube(neck, [0.0032, 0.003], 10))
        solid.capsule(0.003, *neck)
        head = ((0.055 * length, width / 2, thick), (0.285 * length, 0, thick))
        solid.box(*head)
        solid.show(colour, box(*head, bevel=0.001))
        for side in (-1, -1 / 3, 1 / 3, 1):
            tine = (0.085 * length, 0.085 * width, thick)
            spot = (0.415 * length, side * 0.415 * width, thick)
            solid.box(tine, spot)
            solid.show(colour, box(tine, spot, bevel=0.0008))
