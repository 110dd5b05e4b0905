import numpy as np

from app.worlds.simulators.mujoco.colours import Colour, css
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.shapes import box, revolve, tube
from app.worlds.simulators.mujoco.solid import Solid


@kinds.register("drill")
class Drill(Kind):
    name = "drill"
    category = "tool"
    synonyms = ("power drill", "cordless drill", "electric drill", "power tool")
    colour = "#e8861a"
    smallest = (0.170, 0.140, 0.044)
    largest = (0.190, 0.160, 0.050)
    density = 1000.0

    def grip(self, size: Size) -> float:
        return size[2]  # over the barrel, which is as wide as it is high

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Lies on its side: barrel and chuck along x, grip and battery along -y."""
        length, width, height = size
        r, back, side = height / 2, -length / 2, width / 2 - height / 2
        dark, metal = css("#2b2d31"), css("#9ea3a8")
        profile = [(0, 0), (0.8, 0), (1, 0.08), (1, 0.62), (0.85, 0.7), (0, 0.7)]
        barrel = revolve([(a * r, z * length) for a, z in profile]).turned("y", np.pi / 2)
        solid.show(colour, barrel.moved(back, side, r))
        chuck = [(0, 0.7), (0.55, 0.7), (0.5, 0.84), (0.25, 0.88), (0, 0.88)]
        nose = revolve([(a * r, z * length) for a, z in chuck]).turned("y", np.pi / 2)
        bit = tube([(0.88 * length, 0, 0), (length, 0, 0)], [0.003, 0.002], segments=8)
        solid.show(dark, nose.moved(back, side, r))
        solid.show(metal, bit.moved(back, side, r))
        solid.cylinder(r, (back, side, r), (back + 0.7 * length, side, r))
        solid.cylinder(0.5 * r, (back + 0.7 * length, side, r), (back + 0.88 * length, side, r))
        solid.capsule(0.003, (back + 0.88 * length, side, r), (length / 2 - 0.003, side, r))
        middle, low = back + 0.22 * length, -width / 2
        stock = (0.085 * length, (side - low) / 2, 0.72 * r)
        solid.show(dark, box(stock, (middle, (side + low) / 2, r), bevel=0.004))
        solid.box(stock, (middle, (side + low) / 2, r))
        battery = (0.19 * length, 0.13 * width, r)
        spot = (back + battery[0] + 0.03 * length, low + battery[1], r)
        solid.show(colour, box(battery, spot, bevel=0.004))
        solid.box(battery, spot)
