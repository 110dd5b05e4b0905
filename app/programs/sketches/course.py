"""What a composition has come to so far: which things were taken, and where they went."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from app.domain.program import Argument
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing


@dataclass(slots=True)
class Course:
    """Grows with every call that is composed."""

    taken: set[str] = field(default_factory=set)
    """Things that something was done with."""
    moved: list[str] = field(default_factory=list)
    """Things in the order in which they were put somewhere."""
    places: dict[str, str] = field(default_factory=dict)
    """Where they were put."""
    named: set[str] = field(default_factory=set)
    """Things that the sketch names anywhere."""
    counted: Phrase | None = None
    """The words for the set that so many were last taken of."""
    goals: set[str] = field(default_factory=set)
    """Things that the sketch calls by their names as places."""
    sureness: float = 1.0
    """Of the least sure of all words, 0 to 1."""

    @property
    def last(self) -> str | None:
        """What was moved last: the top of a pile."""
        return self.moved[-1] if self.moved else None

    def doubt(self, sureness: float) -> None:
        """Words were told that surely."""
        self.sureness = min(self.sureness, sureness)

    def shared(
        self, placed: Sequence[tuple[Thing, Thing | None]], fixed: Mapping[int, Argument]
    ) -> None:
        """Note that each of a set went to its own place, or all to the fixed one."""
        for member, target in placed:
            for place in [target.name] if target else list(map(str, fixed.values()))[:1]:
                self.places[member.name] = place

    def put(self, thing: str, place: str) -> None:
        """Note that a thing went somewhere."""
        self.moved.append(thing)
        self.places[thing] = place
