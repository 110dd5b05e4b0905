"""What a sketch names, before any of it is composed: all of it, and the places."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from app.domain.action import ActionSignature
from app.programs.knowledge.names import plain
from app.programs.sketches.selection import Selection
from app.programs.sketches.sets import halved
from app.programs.sketches.sketch import Each, Phrase, Rest, Same, SketchArgument, SketchCall
from app.programs.sketches.things import Thing
from app.programs.sketches.verbs import place_of


def named(calls: Sequence[SketchCall], selection: Selection) -> set[str]:
    """The things that the sketch names, so that the rest is known; none where it asks for no rest."""
    arguments = [each for call in calls for each in call.arguments]
    if not any(isinstance(each, Rest) for each in arguments):
        return set()
    rest = next(i for i, each in enumerate(arguments) if isinstance(each, Rest))
    phrases = [
        phrase
        for place, argument in enumerate(arguments)
        if place > rest
        or not _counted(
            argument, selection.sentence
        )  # Of a set counted off before, others are left.
        for phrase in _phrases(argument)
    ]
    return {
        thing.name
        for phrase in phrases
        if selection.possible(phrase)
        for thing in selection.all(phrase).things
    }


def goals(
    calls: Sequence[SketchCall], signatures: Mapping[str, ActionSignature], things: Sequence[Thing]
) -> set[str]:
    """The things that are called by their names as places: a set takes in none of them."""
    names = {plain(thing.name): thing.name for thing in things}
    found: set[str] = set()
    for call in calls:
        signature = signatures.get(call.action)
        place = place_of(signature, ()) if signature else None
        if place is None or place >= len(call.arguments):
            continue
        target = call.arguments[place]
        if isinstance(target, Phrase) and (name := names.get(plain(target.text))):
            found.add(name)
    return found


def _counted(argument: SketchArgument, sentence: str) -> bool:
    """Whether only some of what the words mean are asked for."""
    return isinstance(argument, Phrase) and halved(argument, sentence, 2).count is not None


def _phrases(argument: SketchArgument) -> list[Phrase]:
    match argument:
        case Phrase():
            said = [argument, *(Phrase(text=each) for each in argument.but)]
        case Same() | Each():
            said = [Phrase(text=argument.text)]
        case _:
            said = []
    return [replace(each, quantity="all") for each in said]
