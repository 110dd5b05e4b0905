"""What words for things ask for."""

from dataclasses import dataclass, field

from app.programs.knowledge.classes import VAGUE


@dataclass(frozen=True, slots=True, kw_only=True)
class Description:
    """What a phrase asks for; all that is not given does not matter."""

    text: str
    """The words as they were."""
    core: tuple[str, ...]
    """Noun with what is no property, lower case."""
    whole: tuple[str, ...] = ()
    """The noun with its properties."""
    colours: frozenset[str] = frozenset()
    materials: frozenset[str] = frozenset()
    sizes: frozenset[int] = frozenset()
    side: str | None = None
    superlative: int = 0
    """1 for the largest, -1 for the smallest."""
    ordinal: int = 0
    ordinal_from: str = "left"
    other: bool = False
    """None of those that were spoken of before."""
    relations: tuple[tuple[str, str], ...] = ()
    excluded: tuple["Description", ...] = field(default=())

    @property
    def vague(self) -> bool:
        """Whether no noun says what it is: "the red ones", "everything"."""
        return not self.core or all(each in VAGUE for each in self.core)
