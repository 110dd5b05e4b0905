"""Words → the things of a home: one of a kind is as good as another, and rooms tell which."""

from collections.abc import Collection, Sequence
from dataclasses import replace

from app.domain.condition import Relation
from app.domain.scene import SceneObject
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.names import words
from app.programs.sketches.matching import COUNTS, EXACT
from app.programs.sketches.qualities import Fits, affording
from app.programs.sketches.selection import Found, Judge, Selection
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing, read_things

EQUAL = 0.015
"""Fits this close to the best are as good."""
HEAPS = ("pile", "heap", "stack", "load")
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
    ) -> None:
        """``here`` is the room the agent is in, as the world calls it."""
        self._class_names = {apart(item.name): item.name for item in objects}
        spoken = [replace(item, name=apart(item.name)) for item in objects]
        super().__init__(read_things(spoken), _apart(facts), sentence, judge)
        self._here = apart(here) if here else None
        self._rooms = [thing for thing in self.things if thing.item.category == "room"]

    def class_name(self, spoken: str) -> str:
        """What the world calls it."""
        return self._class_names[spoken]

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
        found = affording(self._loosely(phrase, without), affordance)
        if not found:
            raise self.absent(phrase.text)
        best = max(score for _, score in found)
        equal = [thing for thing, score in found if score >= best - EQUAL]
        there = [thing for thing in equal if room is None or room in _rooms_of(thing)]
        preferred = self._heap(phrase, without) or there or equal
        if holds:
            preferred = [thing for thing in preferred if thing.item.container] or preferred
        return Found((min(preferred, key=self._distance),), best)

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
        """Every kind of thing that the words mean.

        Raises:
            TaskDeclined: nothing fits.
        """
        phrase, _ = self._in_room(phrase)
        if heap := self._heap(phrase, without):
            return Found(tuple(heap), EXACT)
        if self._fitting(phrase, without):
            return super().all(phrase, without, affordance=affordance)
        return self.one(phrase, without, affordance=affordance)

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
