"""What a program does where nothing slips: where things end up, and what else is done."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

from app.domain.errors import ProgramRefused
from app.domain.program import ActionCall, Argument, Comment, Pass, Statement
from app.domain.scene import Scene
from app.programs.parser import parse_program
from app.programs.unrolling import unroll

PUTS: Mapping[str, bool] = dict.fromkeys(
    ("grab_and_putin", "put_on", "place_in", "place_on", "stack", "putin", "putback"), False
)
"""Verbs that move a thing to a place, and whether they name the place first."""


@dataclass(slots=True)
class Outcome:
    """The effects of one program."""

    places: dict[str, str] = field(default_factory=dict)
    """Moved object → what it was last put in or on."""
    deeds: list[tuple[Argument, ...]] = field(default_factory=list)
    """Other actions with their arguments, in order."""
    faults: list[str] = field(default_factory=list)
    """Why it could not be carried out as written."""


def outcome(text: str, scene: Scene, puts: Mapping[str, bool] = PUTS) -> Outcome:
    """The effects of a program's text, loops and helpers written out."""
    found = Outcome()
    try:
        body = unroll(parse_program(text), scene)
    except ProgramRefused as refused:
        found.faults.append(str(refused))
        return found
    run(body, scene.names, puts, found)
    return found


def run(
    body: Sequence[Statement], names: Collection[str], puts: Mapping[str, bool], found: Outcome
) -> None:
    """Carry the statements out, one after the other."""
    for statement in body:
        match statement:
            case ActionCall():
                _perform(statement, names, puts, found)
            case Comment() | Pass():
                pass
            case _:
                found.faults.append(f"not decided here: {statement}")


def _perform(
    call: ActionCall, names: Collection[str], puts: Mapping[str, bool], found: Outcome
) -> None:
    arguments = call.arguments
    if call.action not in puts or len(arguments) != 2:
        found.deeds.append((call.action, *arguments))
        return
    item, place = map(str, arguments[::-1] if puts[call.action] else arguments)
    unknown = [each for each in (item, place) if each not in names]
    if unknown:
        found.faults.append(f"{call.action} of {', '.join(unknown)}")
    elif item == place or _carries(found.places, item, place):
        found.faults.append(f"{item} cannot go into {place}")
    else:
        found.places[item] = place


def _carries(places: Mapping[str, str], item: str, place: str) -> bool:
    """Whether ``place`` stands in or on ``item``."""
    while place in places:
        place = places[place]
        if place == item:
            return True
    return False
