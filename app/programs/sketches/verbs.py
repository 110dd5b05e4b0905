"""The parameters of a verb of the import line: which take things, places, words or persons."""

import re
from collections.abc import Sequence

from app.domain.action import ActionSignature, Parameter
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.sketch import Phrase, SketchArgument, SketchCall

PLACES = word_list("places")
"""Names of parameters that say where a thing goes."""
SPOKEN = word_list("spoken")
"""Names of parameters that take words, not objects."""
HANDOVER = "handover"
"""The verb that brings a thing to a person, whether or not one is named."""
_TAKES = r"(?:me|us|him|her)"
HANDING = re.compile(
    r"^\s*(?:(?:please|now|then|can you|could you|would you|will you|robot|hey)[, ]+)*"
    rf"(?:(?:hand|pass|give|bring|fetch|get|reach|put)(?: over)? {_TAKES}(?: over)? (?!(?:in|on|to)\b)[\w', -]+|"
    r"hand over [\w', -]+|hand [\w', -]+? over|"
    rf"(?:hand|pass|give|bring)(?: over)? [\w', -]+?(?: over)? to {_TAKES})(?:[, ]+(?:please|now|thanks))*[\s.!?]*$",
    re.I,
)
"""A sentence that asks for nothing but to be handed something."""
LITERAL = ("push", "pour", "open", "close", "home", "wipe")
"""Verbs that nobody means who does not say so."""
_ENGLISH = frozenset(("the", "put", "and", "on", "to", "of", "into", "with", "all", "please"))
_ORDERING = word_list("ordering")
_STATES = re.compile(
    r"(?:\b(?:is|are|was|stays?|now|wide|already|an?)|(?<!let)'s) (?:open|closed)\b(?! (?:it|the|up)\b)|"
    r"\b(?:left|leave|kept|standing)(?: (?:the|my|that)(?: \w+){1,3}?)? open\b"
)
"""Open as something is, not as it is to become: "the play kitchen's open!"."""
DIRECTIONS = word_list("directions")
PERSONS = word_list("persons")


def place_of(signature: ActionSignature, several: Sequence[int]) -> int | None:
    """Which argument says where things go, if any does."""
    parameters = signature.parameters
    if len(parameters) < 2:
        return None
    for i, parameter in enumerate(parameters):
        if _is_place(parameter):
            return i
    return 1 - several[0] if len(several) == 1 and len(parameters) == 2 else 1


def _is_place(parameter: Parameter) -> bool:
    return parameter.role in ("container", "support") or parameter.name in PLACES


def spoken_verbs(actions: Sequence[ActionSignature], sentence: str) -> tuple[ActionSignature, ...]:
    """Without verbs like push and pour where an English sentence has no word for them."""
    said = {each.strip(".,!?;:") for each in sentence.lower().split()}
    if not said & _ENGLISH:
        return tuple(actions)
    said = {each.strip(".,!?;:") for each in _STATES.sub(" ", sentence.lower()).split()}
    kept = tuple(
        action
        for action in actions
        if action.name not in LITERAL or said & word_list(f"said of {action.name}")
    )
    return kept or tuple(actions)


def asked_verbs(actions: Sequence[ActionSignature], sentence: str) -> tuple[ActionSignature, ...]:
    """Without verbs that only a sentence asks for that says so: nothing is handed over unasked.

    A place in metres is given in numbers.
    """
    if HANDING.match(sentence):
        return tuple(each for each in actions if each.name == HANDOVER) or tuple(actions)
    said = set(re.findall(r"[\w']+", sentence.lower()))
    if not said & (_ENGLISH | _ORDERING):
        return tuple(actions)
    unasked = set[str]()
    if not said & word_list("said of handover"):
        unasked.add(HANDOVER)
    if not re.search(r"\d", sentence):
        unasked.add("place_at")
    return tuple(action for action in actions if action.name not in unasked)


def righted(call: SketchCall, signature: ActionSignature, sentence: str) -> SketchCall:
    """The call with thing and place the other way round where the sentence plainly says so.

    "stack the red block on the blue block" puts the red one on the blue one.
    """
    place = place_of(signature, ())
    if len(call.arguments) != 2 or place is None or not all(map(_plain, call.arguments)):
        return call
    if not _is_place(signature.parameters[place]):
        return call  # Nothing tells which of them is the place: the sketch knows better.
    thing, target = (str(call.arguments[i]).strip("'") for i in (1 - place, place))
    if _says(sentence, target, thing) and not _says(sentence, thing, target):
        return SketchCall(call.action, call.arguments[::-1])
    return call


def _plain(argument: SketchArgument) -> bool:
    return isinstance(argument, Phrase) and str(argument).startswith(("'", '"'))


def _says(sentence: str, thing: str, target: str) -> bool:
    """Whether "<thing> on the <target>" stands in the sentence."""
    link = r"(?: up)? (?:on|onto|in|into|inside)(?: top)?(?: of)?(?: the| an?| my| your)? "
    return bool(re.search(rf"\b{re.escape(thing)}{link}{re.escape(target)}\b", sentence, re.I))
