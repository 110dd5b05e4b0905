"""Kind: a parametric sort of object, as the catalogue lists it and as a scene builds it."""

from abc import ABC, abstractmethod

import numpy as np

from app.domain.world import ObjectKind
from app.worlds.simulators.mujoco.articulation import Articulation
from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.opening import Opening
from app.worlds.simulators.mujoco.solid import Solid

Size = tuple[float, float, float]
"""Length, width, height of the bounding box at rest [m]."""
GRIPPER = 0.075
"""The widest span the gripper, open 0.08 m, still closes over with some room [m]."""
STRETCH = 1.6
"""A client may ask for sizes outside a kind's own range, by up to this factor."""


class Kind(ABC):
    """One sort of object; ``build`` fills the bounding box it is given."""

    name: str
    category: str
    synonyms: tuple[str, ...] = ()
    """What people also call it, singular, lower case."""
    colour: str
    smallest: Size
    largest: Size
    """What is drawn where a client gives no size."""
    round: bool = False
    """Its length and its width are the same."""
    container: bool = False
    faces: bool = False
    """Its front, -x, is turned towards the robot where its client does not say how it stands."""
    density: float = 600.0
    """Of its collision geoms [kg/m³]; what is hollow inside is lighter than its material."""
    part_density: float = 600.0
    """The same of its moving part, if it has one."""

    @abstractmethod
    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Shape the body: what is seen, and what collides."""

    def opening(self, size: Size) -> Opening | None:
        """The inside of a container of this size; None of what is no container."""
        del size  # Unused.
        return None

    def articulation(self, size: Size) -> Articulation | None:
        """The moving part of what has a drawer, a door or a lid."""
        del size  # Unused.
        return None

    def build_part(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Shape the moving part, in its own frame."""
        raise NotImplementedError(f"a {self.name} has no moving part")

    def grip(self, size: Size) -> float:
        """The least horizontal span a gripper must open to, to take it from above [m]."""
        return min(size[:2])

    def half_extents(self, size: Size) -> tuple[float, float]:
        """Of the footprint, along x and y, centred on the body's origin [m]."""
        return size[0] / 2, size[1] / 2

    def draw_size(self, random: np.random.Generator) -> Size:
        """A size of the kind's own range, to the millimetre."""
        share = random.random(3)
        if self.round:
            share[1] = share[0]
        low, high = np.array(self.smallest), np.array(self.largest)
        length, width, height = (float(value) for value in (low + share * (high - low)).round(3))
        return length, width, height

    def size_fault(self, size: Size) -> str | None:
        """Why an object of this kind cannot have this size; None where it can."""
        low = tuple(round(value / STRETCH, 3) for value in self.smallest)
        high = tuple(round(value * STRETCH, 3) for value in self.largest)
        inside = all(a <= value <= b for a, value, b in zip(low, size, high, strict=True))
        if not inside:  # nan compares false
            return f"is not a size for a {self.name}; from {low} to {high} m would be"
        if self.round and abs(size[0] - size[1]) > 0.001:
            return f"a {self.name} is round; give it the same length and width"
        if not self.container and self.grip(size) > GRIPPER:
            span = f"{self.grip(size):.3f} m"
            return f"leaves {span} to grip where the gripper takes at most {GRIPPER} m"
        return None

    def entry(self) -> ObjectKind:
        """How the catalogue lists it."""
        low, high = np.array(self.smallest), np.array(self.largest)
        length, width, height = (float(value) for value in ((low + high) / 2).round(3))
        return ObjectKind(
            name=self.name,
            category=self.category,
            synonyms=self.synonyms,
            container=self.container,
            size=(length, width, height),
            colour=self.colour,
        )
