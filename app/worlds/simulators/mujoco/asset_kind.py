"""AssetKind: a client's own mesh or body as a kind of object, and the shelf such kinds are found on."""

import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence

import numpy as np

from app.domain.asset import ASSET, Asset
from app.domain.world import ObjectKind
from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.kind import Kind, Size
from app.worlds.simulators.mujoco.solid import Solid
from app.worlds.simulators.mujoco.solid_shape import Shape

KEPT = 64
"""Assets that a process keeps unpacked."""
FLAT_SHADED = 20_000
"""Up to so many faces each has vertices of its own, so that edges stay sharp to the eye."""


class AssetKind(Kind):
    """One asset, solid and of one size."""

    def __init__(self, asset: Asset) -> None:
        self.name = f"{ASSET}{asset.id}"
        self.category = asset.category
        self.synonyms = (asset.name,)
        self.colour = asset.colour
        self.smallest = self.largest = asset.size
        self.density = asset.density
        self._shape = Shape.unpack(asset.shape)

    def build(self, solid: Solid, size: Size, colour: Colour) -> None:
        """Collide as its parts and primitives; be seen as its meshes."""
        del size  # It has but one.
        for part in self._shape.parts:
            solid.hull(part)
        for primitive in self._shape.primitives:
            solid.primitive(primitive)
        for look in self._shape.looks:
            few = len(look.mesh.faces) <= FLAT_SHADED
            solid.show(look.colour or colour, look.mesh.faceted() if few else look.mesh)

    def draw_size(self, random: np.random.Generator) -> Size:
        """The only one."""
        del random  # Unused.
        return self.largest

    def size_fault(self, size: Size) -> str | None:
        """Any other size than its own."""
        same: Sequence[bool] = np.isclose(size, self.largest, rtol=0.0, atol=0.0005).tolist()
        if all(same):
            return None
        own = " x ".join(f"{side:.3f}" for side in self.largest)
        return f"is not the asset's own, {own} m; leave it out, or upload it with another scale"

    def entry(self) -> ObjectKind:
        """As a catalogue would list it."""
        return ObjectKind(
            name=self.name,
            category=self.category,
            synonyms=self.synonyms,
            container=False,
            size=self.largest,
            colour=self.colour,
        )


class AssetShelf:
    """The kinds of assets by name, found where the composition root says."""

    def __init__(self) -> None:
        self._find: Callable[[str], Asset | None] | None = None
        self._kinds: OrderedDict[str, AssetKind] = OrderedDict()
        self._lock = threading.Lock()

    def search(self, find: Callable[[str], Asset | None] | None) -> None:
        """Look assets up by their ids with ``find`` from now on; with None there are none."""
        with self._lock:
            self._find = find
            self._kinds.clear()

    def get(self, name: str) -> AssetKind | None:
        """The kind called ``asset:<id>``, if there is such an asset."""
        if self._find is None or not name.startswith(ASSET):
            return None
        with self._lock:
            if name not in self._kinds:
                asset = self._find(name.removeprefix(ASSET))
                if asset is None:
                    return None
                self._kinds[name] = AssetKind(asset)
            self._kinds.move_to_end(name)
            while len(self._kinds) > KEPT:
                self._kinds.popitem(last=False)
            return self._kinds[name]

    def forget(self, asset_id: str) -> None:
        """Look it up anew the next time."""
        with self._lock:
            self._kinds.pop(f"{ASSET}{asset_id}", None)
