"""Things without an inside, which nobody can open or close: bricks, spoons, balls."""

from app.programs.knowledge.classes import normal
from app.programs.knowledge.membership import endings, head_first
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns

_SOLID = (
    "stone", "rock", "building material", "lumber", "hand tool", "cutlery", "ball", "weight",
    "edible fruit", "vegetable", "coin", "wheel", "bone",
)  # fmt: skip
_NAMED = word_list("solid")
_OPENED = ("container", "book", "furniture", "cutting implement", "device#1", "pliers", "appliance")
"""What one may open or close all the same."""
SURE = 0.6


def is_solid(name: str) -> bool:
    """Whether a thing of this name has surely nothing to open; what is not known may have."""
    if any(each in _NAMED for each in endings(head_first(name))):
        return True
    noun = next((each for each in endings(head_first(name)) if nouns().knows(each)), normal(name))
    solid, opened = (
        max(nouns().is_a(noun, nouns().root(each)) for each in kinds) for kinds in (_SOLID, _OPENED)
    )
    return solid >= SURE and solid > opened
