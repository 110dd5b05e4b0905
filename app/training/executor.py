"""What a program's text does where nothing slips: where things end up, and what else is done."""

import ast
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

PUTS: Mapping[str, bool] = {"grab_and_putin": False, "put_on": False}
"""Verbs that move a thing to a place, and whether they name the place first."""


@dataclass(slots=True)
class Outcome:
    """The effects of one program."""

    places: dict[str, str] = field(default_factory=dict)
    """Moved object → what it was last put in or on."""
    deeds: list[tuple[str, ...]] = field(default_factory=list)
    """Other actions with their arguments, in order."""
    faults: list[str] = field(default_factory=list)
    """Why it could not be carried out as written."""


def outcome(body: str, names: Collection[str], puts: Mapping[str, bool] = PUTS) -> Outcome:
    """Read the indented lines of a function's body (literals only; nothing is evaluated)."""
    found = Outcome()
    try:
        tree = ast.parse(f"def task():\n{body.rstrip()}\n    pass\n")
    except (SyntaxError, ValueError) as error:
        found.faults.append(f"not a program: {error}")
        return found
    for statement in ast.walk(tree):
        if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call):
            _perform(statement.value, names, puts, found)
    return found


def _perform(
    call: ast.Call, names: Collection[str], puts: Mapping[str, bool], found: Outcome
) -> None:
    action = call.func.id if isinstance(call.func, ast.Name) else ""
    arguments = [str(each.value) for each in call.args if isinstance(each, ast.Constant)]
    if action not in puts:
        found.deeds.append((action, *arguments))
        return
    unknown = [each for each in arguments if each not in names]
    if unknown or len(arguments) != 2:
        found.faults.append(f"{action} of {', '.join(unknown or arguments)}")
        return
    item, place = arguments[::-1] if puts[action] else arguments
    if item == place or _carries(found.places, item, place):
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
