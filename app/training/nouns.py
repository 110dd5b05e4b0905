"""Noun phrases: things, sets of things, places for them, in many ways of naming them."""

from app.training.holders import Holders
from app.training.leaving import Leaving
from app.training.names import Names
from app.training.said import Said
from app.training.sets import Sets
from app.training.things import Things
from app.training.words import Words


class Nouns:
    """Everything one sentence may name, no two things of it alike."""

    def __init__(self, words: Words, *, familiar: bool = False) -> None:
        self.words = words
        self.rng = words.rng
        self.names = Names(words, familiar=familiar)
        self.things = Things(self.names)
        self.sets = Sets(self.names)
        self.leaving = Leaving(self.sets)
        self.holders = Holders(self.names)

    def thing(self) -> Said:
        """One thing."""
        return self.things.thing()

    def holder(self) -> Said:
        """A place for things."""
        return self.holders.holder()

    def movable(self) -> Said:
        """Anything that can be asked to be moved."""
        draw = self.rng.random()
        if draw < 0.50:
            return self.thing()
        if draw < 0.61:
            return self.things.several()
        if draw < 0.80:
            return self.sets.all_of()
        return self.leaving.all_but() if draw < 0.91 else self.sets.counted()
