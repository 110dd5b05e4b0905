"""Words → objects: which of the scene's things a phrase means, or why none can be told."""

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from app.domain.condition import Relation
from app.domain.errors import TaskDeclined
from app.programs.knowledge.classes import UNREAL, VAGUE
from app.programs.knowledge.languages import in_english
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.choosing import likeliest
from app.programs.sketches.declared import as_declared
from app.programs.sketches.description import Description
from app.programs.sketches.excluding import heard, without_excluded
from app.programs.sketches.fallbacks import made_so, of_kind, standing_for
from app.programs.sketches.hearsay import without_history
from app.programs.sketches.indefinite import any_one
from app.programs.sketches.matching import (
    COUNTS,
    EXACT,
    HEAD,
    SETS,
    SLIP,
    find_class,
    fit,
    slip,
)
from app.programs.sketches.meaning import Judge, Meaning
from app.programs.sketches.phrase import describe_phrase
from app.programs.sketches.qualities import (
    Fits,
    affording,
    extreme,
    has_properties,
    is_called,
    sized,
)
from app.programs.sketches.questions import absent, ambiguous
from app.programs.sketches.relating import origin, related
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import LIKELY, UNKNOWN, Thing
from app.programs.sketches.whereabouts import as_said, spoken_of
from app.programs.sketches.whole_names import bare, whole_name, without_verb

_REAL = frozenset(("real", "actual", "genuine", "proper", "true"))
_BESIDE = re.compile(
    r"(?<=\w) (?:for|from|about|at|with) (?:the|my|your|our|his|her|a|an|this) .+$", re.I
)
"""What is told of a thing besides what it is: "the food for the picnic"."""
PRONOUNS = word_list("pronouns")


@dataclass(frozen=True, slots=True)
class Found:
    """What a phrase means, and how sure that is."""

    things: tuple[Thing, ...]
    sureness: float


class Selection:
    """Looks phrases up among the things of one scene."""

    def __init__(
        self,
        things: Sequence[Thing],
        facts: frozenset[Relation],
        sentence: str,
        judge: Judge | None = None,
        earlier: Sequence[str] = (),
        asked: str | None = None,
    ) -> None:
        self.things = things
        self.facts = facts
        self.sentence = sentence
        self.asked = asked or sentence
        """As it was typed, for questions back."""
        self._meaning = Meaning(things, asked or sentence, judge)
        self.earlier = tuple(earlier)
        """Names of what the turn before moved."""
        self.spoken: set[str] = set()
        """Names of what this sentence spoke of so far."""

    def one(
        self,
        phrase: Phrase,
        without: Collection[str] = (),
        *,
        holds: bool = False,
        affordance: str | None = None,
    ) -> Found:
        """The object that the words mean; ``holds`` where something is put into it.

        Of what fits, things with the ``affordance`` come first, where the scene tells of any.

        Raises:
            TaskDeclined: nothing fits, or several fit equally well.
        """
        found = affording(self._fitting(phrase, without), affordance)
        if not found:
            raise self.absent(phrase.text)
        equal, best = likeliest(
            found, phrase, self.things, sentence=self.sentence, spoken=self.spoken, holds=holds
        )
        if len(equal) > 1 and not self.indefinite(phrase.text):
            told = self._meaning.tells_one(describe_phrase(phrase), equal)
            if told is None:
                raise ambiguous(phrase.text, equal, self.asked)
            equal = [told]
        return Found((equal[0],), best)

    def all(
        self, phrase: Phrase, without: Collection[str] = (), *, affordance: str | None = None
    ) -> Found:
        """Every object that the words mean, in the scene's order.

        Of what fits, only things with the ``affordance``, where the scene tells of any.

        Raises:
            TaskDeclined: nothing fits.
        """
        found = affording(self._fitting(phrase, without), affordance)
        if not found:
            raise self.absent(phrase.text)
        best = max(score for _, score in found)
        basic = find_class(" ".join(describe_phrase(phrase).core)) is None
        least = HEAD - 0.05 if best >= HEAD - 0.05 and basic else min(SETS, best - 0.03)
        kept = tuple(thing for thing, score in found if score >= least)
        return Found(kept, best)

    def possible(self, phrase: Phrase, without: Collection[str] = ()) -> bool:
        """Whether anything fits at all."""
        return bool(self._fitting(phrase, without))

    def several(self, text: str) -> bool:
        """Whether more than one thing is called so."""
        phrase = Phrase(text=text, quantity="all")
        return self.possible(phrase) and len(self.all(phrase).things) > 1

    def indefinite(self, text: str) -> bool:
        """Whether the sentence speaks of any one of several: "a cup", "one of the cups"."""
        return any_one(text, self.sentence)

    def is_there(self, name: str) -> bool:
        """Whether a thing has exactly this name."""
        return any(thing.name == name for thing in self.things)

    def absent(self, text: str) -> TaskDeclined:
        """Nothing in the scene fits."""
        return absent(text, self.things)

    def _fitting(self, phrase: Phrase, without: Collection[str]) -> Fits:
        """The things of the words, or of the words before "for" and the like where those tell more."""
        shorter = replace(phrase, text=_BESIDE.sub("", phrase.text))
        if shorter == phrase or set(words(shorter.text)) <= VAGUE:
            return self._wholly_fitting(phrase, without)
        if find_class(shorter.text) and not find_class(phrase.text):
            return self._wholly_fitting(shorter, without)
        return self._wholly_fitting(phrase, without) or self._wholly_fitting(shorter, without)

    def _wholly_fitting(self, phrase: Phrase, without: Collection[str]) -> Fits:
        phrase = as_said(without_history(spoken_of(phrase, self.sentence)), self.sentence)
        phrase = heard(phrase, f"{self.sentence}. {self.asked}", self._fitting)
        phrase = whole_name(phrase, self.sentence, self.things)
        described = describe_phrase(phrase)
        if found := self._referred(described, without):
            return found
        if described.other:
            without = {*without, *(self.spoken or self.earlier)}
        if found := self._told_by_use(described, phrase, without):
            return found
        nouns = self._nouns(described, phrase, without)
        found = self._qualified(described, nouns, phrase.quantity == "all")
        if not found and (english := in_english(phrase.text, surely=False)):
            found = self._named(replace(phrase, text=english), without)
        if not found:
            found = self._qualified(described, self._slips(described, without), False)
        if not found and not nouns:
            found = self._instead(described, without, many=phrase.quantity == "all")
        return found if found or nouns else self._told_perhaps(described, without)

    def _told_by_use(
        self, described: Description, phrase: Phrase, without: Collection[str]
    ) -> Fits:
        """What the words or, where they say nothing, the sentence tells plainly by its use."""
        if described.vague and not self._stands_somewhere(described):
            found = self._meaning.told_in_passing(described, without)
            if found:
                return found
        found = self._meaning.plainly(described, phrase, without)
        return self._qualified(described, found, phrase.quantity == "all")

    def _told_perhaps(self, described: Description, without: Collection[str]) -> Fits:
        """What the words are most like in meaning, where no knowledge covers them."""
        perhaps = self._meaning.perhaps(described, without)
        found = self._qualified(described, perhaps, False)
        if not found and described.colours:  # A colour in passing: "golden stuff the bees make".
            found = [(thing, score) for thing, score in perhaps if not thing.item.colour]
        return found or self._meaning.wished(described, without)

    def _nouns(self, described: Description, phrase: Phrase, without: Collection[str]) -> Fits:
        """What the noun fits, whatever else is asked for."""
        found = [
            (thing, score)
            for thing in self.things
            if thing.name not in without and (score := fit(thing, described)) >= COUNTS
        ]
        if described.vague and phrase.quantity == "one" and self.earlier:
            return self._alike(found) or found
        return as_declared(found, described)

    def _named(self, phrase: Phrase, without: Collection[str]) -> Fits:
        described = describe_phrase(phrase)
        nouns = self._nouns(described, phrase, without)
        return self._qualified(described, nouns, phrase.quantity == "all")

    def _instead(self, described: Description, without: Collection[str], *, many: bool) -> Fits:
        """What the words mean that name nothing: what bears it, is of its material or of its kind."""
        free = [t for t in self.things if t.name not in without]
        found = self._qualified(described, standing_for(described, free), False)
        if found or not many:
            return found
        return made_so(described, free) or self._qualified(
            described, of_kind(described, free), True
        )

    def _referred(self, described: Description, without: Collection[str]) -> Fits:
        """What "it" and "them" stand for: what the turn before moved."""
        if described.text.lower() not in PRONOUNS:
            return []
        return [
            (thing, EXACT)
            for thing in self.things
            if thing.name in self.earlier and thing.name not in without
        ]

    def _alike(self, found: Sequence[tuple[Thing, float]]) -> Fits:
        """Those of the kind that was spoken of before: "the blue one" after a block is a block."""
        heads = {
            thing.core[-1] for thing in self.things if thing.name in self.earlier and thing.core
        }
        return [pair for pair in found if pair[0].core and pair[0].core[-1] in heads]

    def _slips(self, described: Description, without: Collection[str]) -> Fits:
        scored = [
            (thing, slip(thing, described)) for thing in self.things if thing.name not in without
        ]
        best = max((score for _, score in scored), default=0.0)
        return [(t, SLIP + 0.1 * score) for t, score in scored if score and score >= best - 0.03]

    def _qualified(self, described: Description, found: Fits, many: bool) -> Fits:
        """Those of the found ones that have what else the phrase asks for."""
        exact = [pair for pair in found if pair[1] >= 0.97 and is_called(pair[0], described)]
        if exact and not many and not described.relations:
            return found
        called = (
            {thing.name for thing, _ in exact} if described.whole != described.core else set[str]()
        )
        kept = [
            (thing, score * sure)
            for thing, score in found
            if (sure := 1.0 if thing.name in called else has_properties(thing, described)) >= LIKELY
        ]
        if not kept and not (many and (described.colours or described.materials)):
            kept = [(t, s * p) for t, s in found if (p := has_properties(t, described)) >= UNKNOWN]
        if described.sizes:
            kept = sized(kept, described, many)
        kept = self._standing_so(kept, described, many)
        if _REAL & set(described.whole):
            kept = [(t, s) for t, s in kept if not UNREAL & set(t.words)]
        for excluded in described.excluded:
            kept = without_excluded(kept, excluded, self._fitting)
        if described.side or described.superlative or described.ordinal:
            kept = extreme(kept, described, many)
        return kept

    def _standing_so(self, kept: Fits, described: Description, many: bool) -> Fits:
        """Those that stand, or come from, where the phrase says."""
        for key, other in described.relations:
            if key == "inside" and (kind := origin(described, other, self.things)):
                kept = [(t, s) for t, s in kept if belonging(t.name, kind) >= COUNTS]
                continue
            anchors = self._fitting(without_verb(Phrase(text=bare(other)), self.things), ())
            kept = related(kept, key, anchors, self.rests, many=many)
        return kept

    def _stands_somewhere(self, described: Description) -> bool:
        """Whether it is told by another thing of the scene."""
        return any(self._fitting(Phrase(text=other), ()) for _, other in described.relations)

    def rests(self, name: str, place: str) -> bool:
        """Whether the one is in or on the other."""
        return any(Relation(key, (name, place)) in self.facts for key in ("in", "on"))
