"""What earlier turns mean at home: "it", "put it back", "now the milk"."""

import re
from collections.abc import Mapping, Sequence

from app.domain.errors import TaskDeclined
from app.domain.planner import Turn
from app.domain.program import ActionCall
from app.domain.scene import SceneObject
from app.programs.home_members import HomeMembers
from app.programs.knowledge.names import words
from app.programs.sketches.dialogue import calls_of

_ANOTHER = re.compile(
    r"(?:(?:and|now|then|next|also|ok|okay|please|the same (?:for|with))[, ]+)+"
    r"(?:the |my |that )?(?P<other>\w+(?: \w+)?)"
    r"(?: (?:too|as well|next|now|please))*[.! ]*",
    re.I,
)
"""Words for another thing, and none for what is to be done."""
_OPPOSITE: Mapping[str, str] = {
    "open": "close",
    "close": "open",
    "switchon": "switch_off",
    "switchoff": "switch_on",
}


def _latest(history: Sequence[Turn]) -> list[ActionCall]:
    """The calls of the latest turn that had a plan."""
    plans = (calls_of(turn.program) for turn in reversed(history))
    return next(filter(None, plans), list[ActionCall]())


def spoken_of(history: Sequence[Turn], members: HomeMembers) -> tuple[str, ...]:
    """What "it" and "them" are: what the latest turn took, else what it worked on last."""
    calls = [each for each in _latest(history) if each.arguments]
    taken = [str(each.arguments[0]) for each in calls if each.action == "grab"]
    worked = [str(each.arguments[0]) for each in calls if each.action in _OPPOSITE][-1:]
    return tuple(dict.fromkeys(map(members.spoken, map(members.class_of, taken or worked))))


def retold(sentence: str, history: Sequence[Turn], members: HomeMembers) -> str:
    """The sentence before with another thing in it, where this one has no more than the thing."""
    other, things = _ANOTHER.fullmatch(sentence.strip()), spoken_of(history, members)
    if other is None or not things:
        return sentence
    before = history[-1].instruction
    said = rf"\b{re.escape(things[-1])}\b"
    told, times = re.subn(said, lambda _: other["other"], before, count=1, flags=re.I)
    return told if times else sentence


def undoing(
    history: Sequence[Turn], objects: Sequence[SceneObject], members: HomeMembers, what: str | None
) -> list[ActionCall]:
    """The activities that bring things back to where they were, the last one first.

    Raises:
        TaskDeclined: nothing was done that could be taken back.
    """
    calls = [each for each in _latest(history) if each.arguments]
    moved = dict.fromkeys(str(e.arguments[0]) for e in reversed(calls) if e.action == "grab")
    wanted = [each for each in moved if not what or words(what) == words(members.spoken(each))]
    places = {each: _place_before(each, history, objects, members) for each in wanted}
    back = [("put", thing, place) for thing, place in places.items() if place]
    if not moved:
        switched = (e for e in reversed(calls) if e.action in _OPPOSITE)
        back = [(_OPPOSITE[each.action], str(each.arguments[0])) for each in switched]
    if not back:
        thing = what or "anything"
        raise TaskDeclined(f"nobody moved {thing} that could be put back", kind="impossible")
    return [
        ActionCall(action=action, arguments=tuple(map(members.spoken, names)))
        for action, *names in back
    ]


def _place_before(
    thing: str, history: Sequence[Turn], objects: Sequence[SceneObject], members: HomeMembers
) -> str:
    """Where an earlier turn had put it, else where the home had it at first."""
    latest = _latest(history)
    for turn in reversed(history):
        calls = calls_of(turn.program)
        for call in reversed(calls if calls != latest else []):
            if call.action.startswith("put") and str(call.arguments[0]) == thing:
                return str(call.arguments[-1])
    kind = members.class_of(thing)
    told = [dict(item.properties).get("place", "") for item in objects if item.name == kind]
    places = " ".join(told).split()
    number = int(thing.removeprefix(kind) or 1)
    return places[number - 1] if number <= len(places) else ""
