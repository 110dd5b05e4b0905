"""What words mean that name nothing in the scene: what bears the thing, is made of it, or is of its kind."""

from collections.abc import Sequence
from dataclasses import replace

from app.programs.knowledge.bearing import stands_for
from app.programs.knowledge.classes import normal
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.properties import MATERIALS
from app.programs.sketches.description import Description
from app.programs.sketches.matching import COUNTS, find_class
from app.programs.sketches.qualities import Fits, has_properties
from app.programs.sketches.things import LIKELY, Thing

_SAID_OF = ("things", "bits", "food")
"""What a word for a kind is said of."""


def standing_for(described: Description, things: Sequence[Thing]) -> Fits:
    """What bears the thing that is asked for: the jug of the milk, a tablet of the medicine."""
    wanted = {normal(" ".join(core)) for core in (described.whole, described.core) if core}
    return [(t, COUNTS) for t in things if any(stands_for(t.name, each) for each in wanted)]


def made_so(described: Description, things: Sequence[Thing]) -> Fits:
    """What is of the material or the colour: "steel instruments" that none is, "glass"."""
    if len(described.core) == 1 and (material := MATERIALS.get(described.core[0])):
        described = replace(described, materials=frozenset((material,)))
    if not described.materials and not described.colours:
        return []
    return [(t, COUNTS) for t in things if has_properties(t, described) >= LIKELY]


def of_kind(described: Description, things: Sequence[Thing]) -> Fits:
    """The things of what the word is said of: electricals are electrical, a breakfast is eaten then."""
    if len(described.core) != 1:
        return []
    word = normal(described.core[0])
    kinds = [kind for thing in _SAID_OF if (kind := find_class(f"{word} {thing}"))]
    for kind in kinds:
        if found := [(t, s) for t in things if (s := belonging(t.name, kind)) >= COUNTS]:
            return found
    return []
