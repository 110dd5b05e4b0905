"""The scene's objects as phrases can speak of them: names taken apart, properties as words."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from app.domain.scene import SceneObject
from app.programs.knowledge.classes import normal
from app.programs.knowledge.languages import in_english
from app.programs.knowledge.membership import head_first
from app.programs.knowledge.names import plain, without_marks, words
from app.programs.knowledge.properties import (
    MATERIALS,
    SIZES,
    SORTS_OF,
    colour_word,
    colours_named,
    made_of,
    materials_named,
    size_named,
    typical_colours,
    typical_size,
)

METAL = "metal"
YES, LIKELY, UNKNOWN, NO = 1.0, 0.9, 0.5, 0.0
"""How surely a thing has a property."""


@dataclass(frozen=True, slots=True)
class Thing:
    """One object of the scene."""

    item: SceneObject
    words: tuple[str, ...]
    """All words of its name."""
    unmarked: str
    """Its name as ``normal`` makes it, without what only tells look-alikes apart."""
    core: tuple[str, ...]
    """The words up to its head noun."""
    english: "Thing | None" = None
    """What its name says, read as another language's, where it could be English too."""

    @property
    def name(self) -> str:
        """As the scene has it."""
        return self.item.name

    def property(self, key: str) -> str | None:
        """What its description says of it."""
        return next((value for name, value in self.item.properties if name == key), None)

    def has_colour(self, colour: str) -> float:
        """How surely it has the colour: by its name, its description, or as a rule."""
        named = colours_named(self.name)
        if named:
            return YES if colour in named else NO
        told = self.item.colour or self.property("colour") or self.property("color")
        typical = typical_colours(self.name)
        made = self.materials() if colour in SORTS_OF else frozenset[str]()
        if colour in made:  # Silver is a metal, too.
            return YES
        if made and not any(each in SORTS_OF or each == METAL for each in made):
            return NO
        if told and (colour_word(told) == colour or colour in words(told)):
            return YES
        if told and colours_named(told):
            return NO  # A white rose is no red thing, however red roses are as a rule.
        if colour in typical:
            return LIKELY
        return NO if told or typical else UNKNOWN

    def colours(self) -> frozenset[str]:
        """The colours it is sure to have, as far as anything tells."""
        named = colours_named(self.name)
        if named:
            return named
        told = self.item.colour or self.property("colour") or self.property("color")
        return frozenset((colour_word(told),)) if told else typical_colours(self.name)

    def has_material(self, material: str) -> float:
        """How surely it is made of the material."""
        if known := self.materials():
            return max(_is_material(each, material) for each in known)
        return max(made_of(self.name, material), 0.2)

    def materials(self) -> frozenset[str]:
        """The materials its name or its description tells."""
        if told := self.property("material"):
            return frozenset((MATERIALS.get(plain(told), plain(told)),))
        return materials_named(self.name)

    def told_size(self) -> int | None:
        """How large its name or its description says it is."""
        told = self.property("size")
        return size_named(self.name) if told is None else SIZES.get(plain(told))

    def measured(self) -> float | None:
        """A number that grows with its size; only for comparing things told of alike."""
        if self.item.size:
            return self.item.size[0] * self.item.size[1] * self.item.size[2]
        return typical_size(self.name)


def _is_material(known: str, wanted: str) -> float:
    """Brass is metal, and metal may be brass; steel is not."""
    if wanted in (known, SORTS_OF.get(known)):
        return YES
    return LIKELY if SORTS_OF.get(wanted) == known else NO


def read_things(objects: Iterable[SceneObject]) -> tuple[Thing, ...]:
    """Every object of the scene, in its order."""
    return tuple(_thing(item) for item in objects)


def _thing(item: SceneObject) -> Thing:
    spoken = in_english(item.name) or item.name
    other = in_english(item.name, surely=False)
    read = _read(item, other) if other and other != spoken else None
    return replace(_read(item, spoken), english=read)


def _read(item: SceneObject, spoken: str) -> Thing:
    found = words(spoken)
    return Thing(item, found, normal(" ".join(without_marks(found))), head_first(spoken))


def listed(names: Sequence[str], word: str = "and") -> str:
    """``a, b and c``."""
    shown = [name if len(name) <= 60 else f"{name[:60]}…" for name in names[:12]]
    if len(names) > 12:
        return f"{', '.join(shown)} and {len(names) - 12} more"
    return f" {word} ".join([", ".join(shown[:-1]), shown[-1]] if len(shown) > 1 else shown)
