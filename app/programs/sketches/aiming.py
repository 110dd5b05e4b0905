"""A push that nobody aims: where the verb wants to be told towards what, and the sentence does not say."""

from dataclasses import replace

from app.domain.action import ActionSignature
from app.programs.sketches.order import stands_behind
from app.programs.sketches.qualities import distance, stands
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase, SketchCall

AIMED = frozenset(("push", "shove", "nudge"))
"""Verbs that only need a direction; any will do where none is told."""


def aimed(call: SketchCall, signature: ActionSignature, selection: Selection) -> SketchCall:
    """The call towards the thing that stands next, where its words for the aim were made up.

    "Push the wagon, my hands are full" says nothing of where to.
    """
    roles = [parameter.role for parameter in signature.parameters]
    if call.action not in AIMED or roles != ["object", "object"] or len(call.arguments) != 2:
        return call
    item, aim = call.arguments
    if not isinstance(item, Phrase) or not isinstance(aim, Phrase):
        return call
    if stands_behind(aim.text, selection.sentence) or not selection.possible(item):
        return call
    mine = selection.one(item).things[0]
    if selection.possible(aim, {mine.name}):
        return call
    others = [thing for thing in selection.things if thing is not mine]
    if not others:
        return call
    nearest = min(others, key=lambda thing: distance(thing, stands(mine)))
    return replace(call, arguments=(item, Phrase(text=nearest.name)))
