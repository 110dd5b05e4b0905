"""A single argument of a sketch's call → the object, the word or the number it stands for."""

from itertools import pairwise

from app.domain.action import Parameter
from app.domain.program import Argument
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.course import Course
from app.programs.sketches.qualities import is_container
from app.programs.sketches.refusals import into_itself
from app.programs.sketches.selection import Selection
from app.programs.sketches.sets import COLLECTIVE, is_plural, means_all
from app.programs.sketches.sketch import Phrase, SketchArgument
from app.programs.sketches.things import Thing
from app.programs.sketches.verbs import DIRECTIONS, PERSONS, SPOKEN

TOP = frozenset(("very", "top", "of", "it", "all", "pile", "stack", "tower", "that", "the"))
"""Words of a place that is on top of what was put there last."""
SO_DO = frozenset((("so", "does"), ("so", "do"), ("as", "does"), ("so", "should"), ("so", "must")))
JOINING = word_list("joining")
"""Words that have one thing go where another went."""


class Arguments:
    """Resolves the arguments of which each stands for one object."""

    def __init__(self, selection: Selection, course: Course) -> None:
        self._selection = selection
        self._course = course

    def value(
        self, argument: SketchArgument, parameter: Parameter, without: set[str], *, holds: bool
    ) -> Argument | None:
        """The object, word or number that stands for a single argument; None for several objects."""
        if not isinstance(argument, Phrase):
            return argument if isinstance(argument, float) else None
        if (word := self._word(argument, parameter)) is not None:
            return word
        if holds and self._course.last and set(words(argument.text)) <= TOP:
            return self._course.last
        if argument.quantity == "all" and argument.count == 1:
            return self._any_one(argument, without, parameter.affordance)
        if not self._selection.possible(argument, without) and self._selection.possible(argument):
            raise into_itself(argument.text)
        if (is_plural(argument) or self._collective(argument) or self.elliptic(argument)) and (
            not holds
        ):
            many = self._selection.all(argument, without)
            if len(many.things) > 1:
                return None
        found = self._selection.one(argument, without, holds=holds, affordance=parameter.affordance)
        self._course.doubt(found.sureness)
        return self._joined(found.things[0], holds=holds)

    def _joined(self, thing: Thing, *, holds: bool) -> str:
        """The thing, or where it was put: "let the car join it there" goes where "it" went."""
        place = self._course.places.get(thing.name)
        said = words(self._selection.sentence)
        joins = bool(JOINING & set(said)) or any(pair in SO_DO for pair in pairwise(said))
        return place if holds and joins and place and not is_container(thing) else thing.name

    def _word(self, phrase: Phrase, parameter: Parameter) -> str | None:
        """The words themselves where the verb takes a direction, a person or the like."""
        plainly = phrase.text.lower()
        if parameter.role == "word" and plainly in parameter.words:
            return plainly
        if parameter.name in SPOKEN and not self._selection.possible(phrase):
            return phrase.text
        spoken = plainly in DIRECTIONS | PERSONS and not self._exactly(plainly)
        return phrase.text if spoken else None

    def elliptic(self, phrase: Phrase) -> bool:
        """Whether it is "glass: green bin", where nobody said "one"."""
        found = words(phrase.text)
        return found[-1:] == ("one",) and "one" not in words(self._selection.sentence)

    def _collective(self, phrase: Phrase) -> bool:
        """Whether the words speak of all there is of a kind: "the cutlery", "the fruit"."""
        if means_all(phrase, self._selection.sentence):
            return True
        found = words(phrase.text)
        mass = bool(found) and found[-1] in COLLECTIVE and not self._exactly(phrase.text.lower())
        return mass and not self._selection.indefinite(phrase.text)

    def _any_one(self, phrase: Phrase, without: set[str], affordance: str | None) -> str:
        """One of those that fit, one that nothing was done with yet if there is any."""
        found = self._selection.all(phrase, without, affordance=affordance)
        self._course.doubt(found.sureness)
        names = [thing.name for thing in found.things]
        return next((name for name in names if name not in self._course.taken), names[0])

    def _exactly(self, text: str) -> bool:
        return any(thing.name.lower() == text for thing in self._selection.things)
