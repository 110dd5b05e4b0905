"""The parameters of a verb of the import line: which take things, places, words or persons."""

from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.programs.knowledge.word_lists import word_list

PLACES = word_list("places")
"""Names of parameters that say where a thing goes."""
SPOKEN = word_list("spoken")
"""Names of parameters that take words, not objects."""
_LITERAL = ("push", "pour", "open", "close", "home")
"""Verbs that nobody means who does not say so."""
_ENGLISH = frozenset(("the", "put", "and", "on", "to", "of", "into", "with", "all", "please"))
DIRECTIONS = word_list("directions")
PERSONS = word_list("persons")


def place_of(signature: ActionSignature, several: Sequence[int]) -> int | None:
    """Which argument says where things go, if any does."""
    parameters = signature.parameters
    if len(parameters) < 2:
        return None
    for i, parameter in enumerate(parameters):
        if parameter.role in ("container", "support") or parameter.name in PLACES:
            return i
    return 1 - several[0] if len(several) == 1 and len(parameters) == 2 else 1


def spoken_verbs(actions: Sequence[ActionSignature], sentence: str) -> tuple[ActionSignature, ...]:
    """Without verbs like push and pour where an English sentence has no word for them."""
    said = {each.strip(".,!?;:") for each in sentence.lower().split()}
    if not said & _ENGLISH:
        return tuple(actions)
    kept = tuple(
        action
        for action in actions
        if action.name not in _LITERAL or said & word_list(f"said of {action.name}")
    )
    return kept or tuple(actions)
