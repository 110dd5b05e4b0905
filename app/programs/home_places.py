"""Where things are put in a home: inside, onto a surface, or somewhere in a room."""

import re
from collections.abc import Sequence

from app.domain.condition import Relation
from app.domain.scene import SceneObject
from app.programs.home_members import HomeMembers
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.names import words

LAID_ON = (
    "diningtable", "kitchentable", "coffeetable", "table", "desk", "kitchencounter",
    "bathroomcounter", "nightstand", "floor",
)  # fmt: skip
"""What things are laid on in a room, the likeliest first."""
INTO = frozenset(("in", "into", "inside"))
ONTO = frozenset(("to", "on", "onto", "upon", "at", "by"))


class HomePlaces:
    """What the things of a home afford, and how something is put there."""

    def __init__(self, objects: Sequence[SceneObject], members: HomeMembers, sentence: str) -> None:
        self.rooms = frozenset(item.name for item in objects if item.category == "room")
        self.affords = {
            name: frozenset(dict(item.properties).get("affordances", "").split())
            for item in objects
            for name in (item.name, *item.members())
        } | dict.fromkeys(self.rooms, frozenset(("surfaces",)))
        self._members = members
        self._sentence = f" {' '.join(words(sentence))} "

    def is_onto(self, place: str) -> bool:
        """Whether "to the nightstand" is onto it: what has a surface is opened for "into" alone."""
        if not {"can_open", "surfaces"} <= self.affords.get(place, frozenset()):
            return False
        said = set(self._sentence.split())
        if said & ONTO and said & INTO:
            inside, name = "|".join(sorted(INTO)), apart(self._members.class_of(place))
            return not re.search(rf" (?:{inside}) (?:\w+ )?{name} ", self._sentence)
        return not said & INTO

    def verb(self, place: str) -> str:
        """What puts a thing there."""
        affords = self.affords[place]
        inside = "can_open" in affords or "surfaces" not in affords
        return "putin" if inside and affords & {"containers", "can_open"} else "putback"

    def laid_in(self, room: str) -> str:
        """Where a thing is laid that is to go to a room."""
        known = [name for name in LAID_ON if name in self.affords]
        there = (self._members.one_within(name, room) for name in known)
        return next((e for e in there if self._members.holds(Relation("in", (e, room)))), "floor")
