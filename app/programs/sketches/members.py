"""An argument that stands for several objects → its members, and the places they are shared out among."""

import re
from dataclasses import replace

from app.domain.errors import Fault, ProgramRefused, TaskDeclined
from app.domain.program import Argument
from app.programs.knowledge.classes import normal
from app.programs.knowledge.names import words
from app.programs.sketches.arguments import Arguments
from app.programs.sketches.course import Course
from app.programs.sketches.denied import undenied
from app.programs.sketches.description import Description
from app.programs.sketches.heights import piled
from app.programs.sketches.openings import BEFORE, openable
from app.programs.sketches.phrase import describe_phrase
from app.programs.sketches.qualities import ordered
from app.programs.sketches.refusals import BESIDE
from app.programs.sketches.selection import Selection
from app.programs.sketches.sets import (
    but_some,
    halved,
    left_over,
    movable,
    really_said,
    rest_of_kind,
    speaks_of_rest,
    staying,
)
from app.programs.sketches.sketch import Each, Phrase, Rest, Same, SketchArgument
from app.programs.sketches.things import Thing, listed


class Members:
    """Looks sets up among the things of one scene."""

    def __init__(
        self, selection: Selection, course: Course, arguments: Arguments, *, going_on: bool
    ) -> None:
        self._selection = selection
        self._course = course
        self._arguments = arguments
        self._going_on = going_on

    def targets(self, spread: SketchArgument | None, argument: SketchArgument) -> tuple[Thing, ...]:
        if not isinstance(spread, Same | Each):
            return ()
        if isinstance(argument, Phrase) and spread.text == argument.text:
            return self._others(argument)
        return self._selection.all(Phrase(text=spread.text, quantity="all")).things

    def _others(self, argument: Phrase) -> tuple[Thing, ...]:
        """What the sentence speaks of besides the members, where the sketch repeats their words."""
        members = {thing.name for thing in self._selection.all(argument).things}
        for word in words(self._selection.sentence):
            phrase = Phrase(text=word, quantity="all")
            if self._selection.possible(phrase, members):
                return self._selection.all(phrase, members).things
        raise self._selection.absent(f"other place than {argument.text}")

    def of(
        self,
        argument: SketchArgument,
        avoid: set[str],
        fixed: dict[int, Argument],
        affordance: str | None,
        action: str = "",
    ) -> list[Thing]:
        if isinstance(argument, Rest):
            argument = rest_of_kind(self._selection.sentence, self._selection) or argument
        if isinstance(argument, Rest):
            return self._rest(avoid, fixed, action)
        if not isinstance(argument, Phrase):
            raise ProgramRefused(Fault(field="program", message="a set is wanted"))
        argument = really_said(argument, self._selection.sentence, self._selection.things)
        avoid = avoid | staying(self._selection.things, self._selection.asked)
        argument = but_some(argument, self._selection.sentence)
        places = avoid | self._course.goals
        avoid = places if self._selection.possible(argument, places) else avoid
        selected = self._selection.all(argument, avoid, affordance=affordance)
        self._course.doubt(selected.sureness)
        found = list(selected.things)
        described = describe_phrase(argument)
        if described.vague:
            found = self._meant(found, argument, described, fixed, action)
        found = undenied(found, described, self._selection.things, self._selection.sentence)
        found = ordered(found, piled(argument.order, self._selection.sentence))
        argument = halved(argument, self._selection.sentence, len(found))
        argument = left_over(argument, self._selection.sentence, len(found))
        if argument.count is not None:
            return self._counted(argument, found, fixed)
        if not found:
            raise self._selection.absent(argument.text)
        return found

    def _rest(self, avoid: set[str], fixed: dict[int, Argument], action: str) -> list[Thing]:
        """Of what the sketch does not name, what such a verb is for."""
        out = avoid | self._course.named | self._course.taken
        others = self._others_said([t for t in self._selection.things if t.name not in out])
        if action in BEFORE:
            found = openable(others, action, self._selection)
        else:
            found = movable(others, self._selection, placed=bool(fixed))
        if not found:
            raise self._selection.absent("other thing")
        return found

    def _meant(
        self,
        found: list[Thing],
        argument: Phrase,
        described: Description,
        fixed: dict[int, Argument],
        action: str,
    ) -> list[Thing]:
        """What "everything" stands for; beside a thing, or of a colour, it is really all."""
        if action in BEFORE:
            return openable(found, action, self._selection)
        told = described.colours or described.materials or described.sizes
        beside = any(key in BESIDE for key, _ in described.relations)
        if beside or (told and not self._arguments.elliptic(argument)):
            return found
        return movable(found, self._selection, placed=bool(fixed))

    def _others_said(self, free: list[Thing]) -> list[Thing]:
        """Those of the kind that is told: of "the other marker" no pen.

        Of "two blocks here, the rest there" it is the kind that was counted.
        """
        counted = self._course.counted
        if counted and speaks_of_rest(self._selection.sentence):
            phrase = replace(counted, count=None)
            alike = self._selection.all(phrase).things if self._selection.possible(phrase) else ()
            free = [thing for thing in free if thing in alike] or free
        match = re.search(r"\bthe other (\w+)", self._selection.sentence, re.I)
        said = normal(match[1]) if match else ""
        return [thing for thing in free if said in map(normal, thing.words)] or free

    def _counted(
        self, phrase: Phrase, found: list[Thing], fixed: dict[int, Argument]
    ) -> list[Thing]:
        """So many of them, those first that nothing was done with yet."""
        count = phrase.count or 0
        self._course.counted = phrase
        there = {str(each) for each in fixed.values()}
        fresh = [
            thing
            for thing in found
            if thing.name not in self._course.taken
            and not any(self._selection.rests(thing.name, place) for place in there)
        ]
        if len(found) < count:
            have = listed([thing.name for thing in found])
            only = f"only {len(found)}: {have}" if found else "none"
            raise TaskDeclined(
                f"{count} {phrase.text} are asked for and there is {only}",
                kind="absent",
                question=f"Should the {len(found)} be taken?" if found else None,
            )
        rest = [thing for thing in found if thing not in fresh]
        done = [t for t in rest if any(self._selection.rests(t.name, place) for place in there)]
        return ((done if self._going_on else []) + fresh + rest)[:count]
