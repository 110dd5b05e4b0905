"""Words → the things of a home: one of a kind is as good as another, and rooms tell which."""

from collections.abc import Collection, Sequence
from dataclasses import replace

from app.domain.condition import Relation
from app.domain.errors import TaskDeclined
from app.domain.scene import SceneObject
from app.programs.home_answers import nearest_things
from app.programs.home_members import HomeMembers, room_told
from app.programs.knowledge.classes import normal
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.names import words
from app.programs.sketches.matching import COUNTS, EXACT
from app.programs.sketches.qualities import Fits, affording
from app.programs.sketches.selection import Found, Judge, Selection
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing, listed, read_things
from app.programs.sketches.whereabouts import spoken_of

EQUAL = 0.015
"""Fits this close to the best are as good."""
HEAPS = ("pile", "heap", "stack", "load")
EVERY = frozenset(("all", "every", "each", "both", "everything"))
MOST = 12
"""Single things that one phrase stands for."""
_LINKS = ("on", "in", "under", "from", "at", "by", "near", "off", "of", "with", "inside", "beside")


class HomeSelection(Selection):
    """Looks phrases up among the classes of things in one home."""

    def __init__(
        self,
        objects: Sequence[SceneObject],
        facts: frozenset[Relation],
        sentence: str,
        judge: Judge,
        here: str | None = None,
        members: HomeMembers | None = None,
    ) -> None:
        """``here`` is the room the agent is in, as the world calls it."""
        self._judge = judge
        self._members = members or HomeMembers(objects)
        names = [n for item in objects for n in (item.name, *self._members.of(item.name))]
        self._class_names = {self._members.spoken(name): name for name in names}
        self._told = apart(room_told(objects, sentence, before=("in", "of", "from", "inside")))
        """The room that things are said to be in."""
        spoken = [replace(item, name=apart(item.name)) for item in objects]
        super().__init__(read_things(spoken), _apart(facts), sentence, judge)
        self._here = apart(here) if here else None
        self._rooms = [thing for thing in self.things if thing.item.category == "room"]

    def class_name(self, spoken: str) -> str:
        """What the world calls it."""
        return self._class_names[spoken]

    def is_there(self, name: str) -> bool:
        """Whether a class of things is called so, or a single one of it."""
        return name in self._class_names

    def one(
        self,
        phrase: Phrase,
        without: Collection[str] = (),
        *,
        holds: bool = False,
        affordance: str | None = None,
    ) -> Found:
        """The likeliest; of several that fit as well one of the room that is told, or of this one.

        Raises:
            TaskDeclined: nothing fits.
        """
        phrase, room = self._in_room(phrase)
        room = room or self._told or None
        found = affording(self._loosely(phrase, without), affordance)
        if not found:
            raise self.absent(phrase.text)
        best = max(score for _, score in found)
        equal = [thing for thing, score in found if score >= best - EQUAL]
        there = [thing for thing in equal if room is None or room in _rooms_of(thing)]
        preferred = self._heap(phrase, without) or there or equal
        if holds:
            preferred = [thing for thing in preferred if thing.item.container] or preferred
        chosen = min(preferred, key=self._distance)
        if holds and chosen.name == self._told:
            self._told = ""  # It is where things go, not where they are.
        return Found((self._within(chosen, room),), best)

    def _within(self, thing: Thing, room: str | None) -> Thing:
        """The one of them in that room."""
        if room is None or thing.item.category == "room":
            return thing
        name, place = self.class_name(thing.name), self.class_name(room)
        return self._called(thing, self._members.one_within(name, place))

    def _called(self, thing: Thing, name: str) -> Thing:
        return replace(thing, item=replace(thing.item, name=self._members.spoken(name)))

    def _heap(self, phrase: Phrase, without: Collection[str]) -> list[Thing]:
        """What is all of them together: the clothes pile, where clothes are meant."""
        said = words(phrase.text)
        heaps = [t for t in self.things if t.words[:-1] == said and t.words[-1] in HEAPS]
        return [thing for thing in heaps if thing.name not in without]

    def _distance(self, thing: Thing) -> tuple[bool, bool]:
        """Things before rooms, and what is in this room before the rest."""
        return thing.item.category == "room", self._here not in _rooms_of(thing)

    def all(
        self, phrase: Phrase, without: Collection[str] = (), *, affordance: str | None = None
    ) -> Found:
        """Everything that the words mean: each of several plates, where plates are meant.

        Raises:
            TaskDeclined: nothing fits.
        """
        phrase, room = self._in_room(phrase)
        if heap := self._heap(phrase, without):
            return Found(tuple(heap), EXACT)
        if self._fitting(phrase, without):
            found = super().all(phrase, without, affordance=affordance)
        else:
            found = self.one(phrase, without, affordance=affordance)
        things = self._each(found.things, phrase, room or self._told or None)
        return Found(things[:MOST], found.sureness)

    def _each(
        self, things: tuple[Thing, ...], phrase: Phrase, room: str | None
    ) -> tuple[Thing, ...]:
        """The single things of the classes, of those in the room where one is told."""
        if room is not None:
            things = tuple(t for t in things if room in _rooms_of(t)) or things
        if phrase.count is not None and len(things) >= phrase.count:
            return things
        return tuple(each for thing in things for each in self._single(thing, phrase, room))

    def _single(self, thing: Thing, phrase: Phrase, room: str | None) -> tuple[Thing, ...]:
        members = self._members.of(self.class_name(thing.name))
        if room is not None:
            members = self._members.within(members, self.class_name(room)) or members
        members = self._standing(members, phrase) or members
        spoken, said = words(phrase.text), set(words(self.sentence))
        # Curtains and pants are spoken of so even where one pair is meant.
        paired = normal(thing.words[-1]) != thing.words[-1]
        plural = bool(spoken) and normal(spoken[-1]) != spoken[-1] and not paired
        if not members or not (plural or said & EVERY):
            return (thing,)
        return tuple(self._called(thing, name) for name in members)

    def _standing(self, members: tuple[str, ...], phrase: Phrase) -> tuple[str, ...]:
        """Those of them that are in or on what the phrase tells: the pillows on the sofa."""
        for key, other in spoken_of(phrase, self.sentence).relations:
            anchor = Phrase(text=other)
            if key in ("on", "inside") and self.possible(anchor):
                place = self.one(anchor).things[0].name
                members = tuple(m for m in members if self.rests(self._members.spoken(m), place))
        return members

    def rests(self, name: str, place: str) -> bool:
        """Whether the one is in or on the other."""
        told = (self.class_name(name), self.class_name(place))
        if self._members.class_of(told[0]) == told[0]:
            return super().rests(name, place)
        return any(self._members.holds(Relation(key, told)) for key in ("in", "on"))

    def _loosely(self, phrase: Phrase, without: Collection[str]) -> Fits:
        """What fits; else what fits the words before "on" or "from", or the words but the last.

        Last of all what is named after the thing: a coffee pot where coffee is wanted.
        """
        said = words(phrase.text)
        whole = [t for t in self.things if self._class_names[t.name] == "".join(said)]
        if whole and whole[0].name not in without:
            return [(whole[0], EXACT)]
        if found := self._fitting(phrase, without):
            return found
        place = next((i for i, word in enumerate(said) if i and word in _LINKS), len(said) - 1)
        for shorter in (said[:place], said[: len(said) - 1]):
            if shorter and (found := self._fitting(Phrase(text=" ".join(shorter)), without)):
                return found
        return [
            (thing, COUNTS)
            for thing in self.things
            if thing.name not in without and said and thing.words[: len(said)] == said
        ]

    def _in_room(self, phrase: Phrase) -> tuple[Phrase, str | None]:
        """The phrase without the room it begins or ends with, and that room."""
        said = words(phrase.text)
        for room in self._rooms:
            name = words(room.name)
            size = len(name)
            if len(said) > size and said[:size] == name and not self._exact(phrase.text):
                return replace(phrase, text=" ".join(said[size:])), room.name
            if len(said) > size + 1 and said[-size:] == name:
                kept = [w for w in said[:-size] if w not in ("in", "of", "from", "the", "on", "at")]
                return replace(phrase, text=" ".join(kept)), room.name
        return phrase, None

    def absent(self, text: str) -> TaskDeclined:
        """Nothing in the home fits: the nearest things are named."""
        names = [thing.name for thing in self.things if thing.item.category != "room"]
        alike = nearest_things(text, names, self._judge)
        told = (
            f"; the nearest to it is {listed(alike, 'or')}" if alike else ", nor anything like it"
        )
        return TaskDeclined(
            f"there is no {text} here{told}",
            kind="absent",
            question=f"What do you mean by {text!r}?",
        )

    def possible(self, phrase: Phrase, without: Collection[str] = ()) -> bool:
        """Whether anything fits at all, loosely."""
        return bool(self._loosely(self._in_room(phrase)[0], without))

    def _exact(self, text: str) -> bool:
        return any(words(thing.name) == words(text) for thing in self.things)


def _rooms_of(thing: Thing) -> tuple[str, ...]:
    told = dict(thing.item.properties).get("room", "")
    return tuple(apart(each) for each in told.split())


def _apart(facts: frozenset[Relation]) -> frozenset[Relation]:
    return frozenset(Relation(f.name, tuple(map(apart, f.arguments))) for f in facts)
