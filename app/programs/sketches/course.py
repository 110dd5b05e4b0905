"""What a composition has come to so far: which things were taken, and where they went."""

from dataclasses import dataclass, field

from app.programs.sketches.sketch import Phrase


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

    def put(self, thing: str, place: str) -> None:
        """Note that a thing went somewhere."""
        self.moved.append(thing)
        self.places[thing] = place
