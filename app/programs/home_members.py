"""The single things of a home where a class has several, and the room a sentence speaks of."""

import re
from collections.abc import Callable, Iterable, Sequence

from app.domain.condition import Relation
from app.domain.scene import SceneObject
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.names import words

Holds = Callable[[Relation], bool]
"""Whether something is so where the plan begins."""


class HomeMembers:
    """What each of several plates is called, and where it is."""

    def __init__(self, objects: Sequence[SceneObject], holds: Holds | None = None) -> None:
        """Without ``holds`` nothing is known of the single things, and classes stand for them."""
        self._members = {item.name: item.members() if holds else () for item in objects}
        self._classes = {each: name for name, members in self._members.items() for each in members}
        self._holds = holds

    def class_of(self, name: str) -> str:
        """``plate`` of ``plate 2``; any other name is that of a class."""
        return self._classes.get(name, name)

    def spoken(self, name: str) -> str:
        """As people write it: ``toy car 2`` of ``toycar 2``."""
        kind = self.class_of(name)
        return f"{apart(kind)}{name.removeprefix(kind)}"

    def of(self, name: str) -> tuple[str, ...]:
        """The single things of a class; none where there is but one."""
        return self._members.get(name, ())

    def holds(self, relation: Relation) -> bool:
        """Whether it is known to be so where the plan begins."""
        return self._holds is not None and self._holds(relation)

    def within(self, names: Iterable[str], room: str) -> tuple[str, ...]:
        """Those of them that are in the room."""
        return tuple(each for each in names if self.holds(Relation("in", (each, room))))

    def one_within(self, name: str, room: str) -> str:
        """The first of the class in the room; the class where none or all of them are there."""
        members = self.of(name)
        there = self.within(members, room)
        return there[0] if there and len(there) < len(members) else name


def room_told(objects: Sequence[SceneObject], sentence: str, *, before: Sequence[str] = ()) -> str:
    """The room that the sentence names, as the home calls it; empty where it names none or several.

    A kitchen table is no kitchen. With ``before`` only a room that comes after one of these words.
    """
    said = f" {' '.join(words(sentence))} "
    rooms = [item.name for item in objects if item.category == "room"]
    for item in objects:
        if item.name not in rooms and any(apart(item.name).startswith(f"{r} ") for r in rooms):
            said = said.replace(f" {apart(item.name)} ", " thing ")
    leads = [f" {each}{of}" for each in before for of in ("", " the", " my", " our")] or [""]
    told = [
        room
        for room in rooms
        if any(f"{lead} {name} " in said for lead in leads for name in {room, apart(room)})
    ]
    return told[0] if len(told) == 1 else ""


_OPERATED = re.compile(r"(?:please |can you |could you )?(?:open|close|shut|turn|switch)\b", re.I)


def without_room(objects: Sequence[SceneObject], sentence: str) -> str:
    """The sentence without "in the bedroom" where that only tells which window is to be opened."""
    room = room_told(objects, sentence, before=("in", "of"))
    if not room or not _OPERATED.match(sentence):
        return sentence
    names = "|".join(re.escape(name) for name in (room, apart(room)))
    shorter = re.sub(rf" (?:in|of) (?:the |my |our )?(?:{names})\b", "", sentence, flags=re.I)
    return " ".join(shorter.split())
