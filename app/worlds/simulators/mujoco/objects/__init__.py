"""The object kinds, one a file, and how a name finds its kind."""

from functools import cache

from app.registry import Registry
from app.worlds.simulators.mujoco.asset_kind import AssetShelf
from app.worlds.simulators.mujoco.kind import Kind
from app.worlds.simulators.mujoco.matching import best_match


class Kinds(Registry[Kind]):
    """The kinds of this folder, and by ``asset:<id>`` the meshes clients brought.

    Those are found by name only: whoever goes through all kinds meets the folder's.
    """

    assets = AssetShelf()

    def __getitem__(self, name: str) -> Kind:
        return self.assets.get(name) or super().__getitem__(name)

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and (
            self.assets.get(name) is not None or super().__contains__(name)
        )


kinds = Kinds(__name__, "object kind")
ANY = "neutral"
"""The kind of what has none of its own."""
ANY_CONTAINER = "box"


def match(name: str, *, container: bool = False) -> str:
    """The kind an object of this name is most likely of; with ``container``, one that holds things.

    ``ANY`` or ``ANY_CONTAINER`` where the name tells nothing.
    """
    found = best_match(name, vocabulary())
    if container:
        return found if found and kinds[found].container else ANY_CONTAINER
    return found or ANY


@cache
def vocabulary() -> dict[str, str]:
    """Every kind's name and synonyms, as people say them, to the kind's name."""
    named = {name.replace("_", " "): name for name in kinds}
    spoken = {word: name for name in kinds for word in kinds[name].synonyms}
    return {**spoken, **named}
