"""The object kinds, one a file, and how a name finds its kind."""

from functools import cache

from app.registry import Registry
from app.worlds.simulators.mujoco.kind import Kind
from app.worlds.simulators.mujoco.matching import best_match

kinds: Registry[Kind] = Registry(__name__, "object kind")
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
