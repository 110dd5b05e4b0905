"""Which of a verb's two arguments is which, where the sentence's small words tell it."""

import re
from collections.abc import Sequence
from dataclasses import replace

from app.domain.action import ActionSignature
from app.programs.knowledge.names import stem, words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.sketch import Phrase, SketchCall
from app.programs.sketches.verbs import PLACES

TOOLS = word_list("tools")
"""Names of parameters for what something is done with."""
_PLACING = "into|onto|over|in|on|to|at|against|through|around|towards|toward|inside|across"
_BEFORE = (
    r"\b({})\s+(?:top of\s+)?(?:the\s+|an?\s+|my\s+|your\s+|its\s+|his\s+|her\s+|some\s+)?{}\b"
)


def told_apart(call: SketchCall) -> SketchCall:
    """The call without the place in the words for the thing: "the pen in the box", "the box"."""
    if len(call.arguments) != 2 or not all(isinstance(each, Phrase) for each in call.arguments):
        return call
    thing, place = call.arguments
    if not isinstance(thing, Phrase) or not isinstance(place, Phrase):
        return call
    ending = (
        rf"\s+(?:in|into|on|onto|inside)\s+(?:(?:the|my|your|a|an)\s+)?{re.escape(place.text)}$"
    )
    text = re.sub(ending, "", thing.text, flags=re.I)
    return SketchCall(call.action, (replace(thing, text=text), place)) if text else call


def in_order(call: SketchCall, signature: ActionSignature, sentence: str) -> SketchCall:
    """The call with its arguments the other way round where the sentence plainly says so.

    "label the crate with the sticker": what is labelled comes first, the sticker stands behind
    "with". Where the parameters' names tell which is the place or the tool, they decide; else the
    second one is.
    """
    if len(call.arguments) != 2:
        return call
    texts = [each.text for each in call.arguments if isinstance(each, Phrase)]
    if len(texts) != 2 or texts[0] == texts[1]:
        return call
    told = ((PLACES, _PLACING), (TOOLS, "with|using"))
    if any(len(re.findall(rf"\b{re.escape(each)}\b", sentence, re.I)) > 1 for each in texts):
        return call  # Behind "on" it may stand as the place of something else.
    for kind, links in told[: 1 if _puts(call.action) else 2]:
        behind = [stands_behind(text, sentence, links) for text in texts]
        if behind[0] != behind[1]:
            named = [parameter.name in kind for parameter in signature.parameters]
            oblique = 0 if named[0] and not named[1] else 1
            return call if behind[oblique] else SketchCall(call.action, call.arguments[::-1])
    return call


def _puts(action: str) -> bool:
    """Whether it moves its first thing: what a bowl is filled "with" is no tool."""
    return bool({"put", "putin", "place", "insert"} & set(words(action.replace("_", " "))))


def stands_behind(text: str, sentence: str, links: str = _PLACING) -> bool:
    """Whether the words follow one of the links, "to the" ramp."""
    return bool(re.search(_BEFORE.format(links, re.escape(text)), sentence, re.I))


def unsaid(
    calls: Sequence[SketchCall], actions: Sequence[ActionSignature], sentence: str
) -> set[str]:
    """The verbs that the sentence says and that no call is of; none where it says "not"."""
    found = words(sentence)
    if set(found) & _NEGATIONS:
        return set()
    said = {stem(each) for each in found}
    called = {call.action for call in calls}
    return {a.name for a in actions if a.name not in called and said_in(a.name, said)}


def said_in(action: str, said: set[str]) -> bool:
    """Whether all words of its name but the smallest stand among these stems of a sentence."""
    parts = [stem(each) for each in words(action) if len(each) > 2 and each not in _SMALL]
    return not set(parts) <= _PUTTING and all(part in said for part in parts)


_SMALL = frozenset(("and", "into", "onto", "with", "from", "obj", "object", "item"))
_PUTTING = frozenset(("put", "place", "move", "set", "lay"))
"""Verbs that any other verb of putting says as well."""
_NEGATIONS = frozenset(
    ("not", "don't", "dont", "never", "no", "without", "instead", "rather", "leave")
)
