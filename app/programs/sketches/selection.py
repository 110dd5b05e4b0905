"""Words → objects: which of the scene's things a phrase means, or why none can be told."""

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from app.domain.condition import Relation
from app.domain.errors import TaskDeclined
from app.programs.knowledge.classes import UNREAL, normal
from app.programs.knowledge.languages import in_english
from app.programs.knowledge.names import is_mark, plain, words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.declared import as_declared
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
from app.programs.sketches.phrase import Description, describe_phrase, spoken_of
from app.programs.sketches.qualities import (
    AXES,
    Fits,
    affording,
    distance,
    extreme,
    has_properties,
    is_called,
    is_container,
    is_placed,
    sized,
    stands,
)
from app.programs.sketches.questions import absent, ambiguous
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import LIKELY, UNKNOWN, Thing

_REAL = frozenset(("real", "actual", "genuine", "proper", "true"))
_MODALS = frozenset(("can", "could", "will", "would", "should", "must", "may", "goes", "go", "is"))
PRONOUNS = word_list("pronouns")
_INDEFINITE = (
    r"(?:an?|any|one|some|another|either|ein(?:e[nmrs]?)?|une?|una?|uno|uma?|eene?|irgendein\w*)"
    r"(?: of the| of these| of those| single| of)?"
)


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
        best = max(score for _, score in found)
        if holds and best < HEAD - 0.02:
            found = [p for p in found if is_container(p[0])] or self._named_after(phrase) or found
            best = max(score for _, score in found)
        equal = [thing for thing, score in found if score >= best - 0.015]
        if len(equal) > 1 and holds:
            equal = [thing for thing in equal if is_container(thing)] or equal
        equal = self._twins(equal, phrase, found, best)
        if len(equal) > 1 and "other" in words(self.sentence):
            equal = [t for t in equal if t.name not in self.spoken] or equal
        if len(equal) > 1 and not UNREAL & set(words(phrase.text)):
            equal = [t for t in equal if not UNREAL & set(t.words)] or equal
        if len(equal) > 1:
            whole = [t for t in equal if len(t.words) > 1 and plain(t.name) in plain(self.sentence)]
            equal = whole if len(whole) == 1 else equal
        if len(equal) > 1 and not self.indefinite(phrase.text):
            raise ambiguous(phrase.text, equal, self.asked)
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

    def _named_after(self, phrase: Phrase) -> Fits:
        """The one container that has the words in its name: "with the paper" is the paper bin."""
        said = set(describe_phrase(phrase).core)
        named = [t for t in self.things if said <= set(t.words) and is_container(t)]
        return [(named[0], COUNTS)] if said and len(named) == 1 else []

    def possible(self, phrase: Phrase, without: Collection[str] = ()) -> bool:
        """Whether anything fits at all."""
        return bool(self._fitting(phrase, without))

    def several(self, text: str) -> bool:
        """Whether more than one thing is called so."""
        phrase = Phrase(text=text, quantity="all")
        return self.possible(phrase) and len(self.all(phrase).things) > 1

    def indefinite(self, text: str) -> bool:
        """Whether the sentence speaks of any one of several: "a cup", "one of the cups"."""
        spoken = r"\s+".join(map(re.escape, text.split()))
        return bool(re.search(rf"\b{_INDEFINITE}\s+{spoken}", self.sentence, re.I))

    def absent(self, text: str) -> TaskDeclined:
        """Nothing in the scene fits."""
        return absent(text, self.things)

    def _twins(
        self,
        equal: list[Thing],
        phrase: Phrase,
        found: Sequence[tuple[Thing, float]],
        best: float,
    ) -> list[Thing]:
        """With the look-alikes of the one called exactly so: "cup" where there is a "cup 2"."""
        if len(equal) != 1 or not best > 0.97 or is_mark(equal[0].words[-1]):
            return equal
        if describe_phrase(phrase).side or describe_phrase(phrase).ordinal:
            return equal
        return [
            thing
            for thing, _ in found
            if thing is equal[0]
            or (
                len(thing.words) == len(equal[0].words) + 1
                and thing.words[:-1] == equal[0].words
                and thing.words[-1].isdigit()
                and thing.name.lower()
                == f"{equal[0].name.lower()}{thing.name[len(equal[0].name)]}{thing.words[-1]}"
            )
        ]

    def _fitting(self, phrase: Phrase, without: Collection[str]) -> Fits:
        phrase = self._whole(spoken_of(phrase, self.sentence))
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
        if not found and not nouns and phrase.quantity == "all":
            found = self._made_so(described, without)
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
        found = self._qualified(described, self._meaning.perhaps(described, without), False)
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

    def _whole(self, phrase: Phrase) -> Phrase:
        """The whole name where the phrase stands only as a part of it: "desk" of the desk tidy."""
        phrase = self._without_verb(phrase)
        said = plain(self.sentence)
        text = plain(phrase.text)
        longer = [
            name
            for thing in self.things
            if (name := plain(thing.name)) in said
            and (name.startswith(f"{text} ") or name.endswith(f" {text}"))
        ]
        alone = len(longer) == 1 and text not in said.replace(longer[0], "")
        return replace(phrase, text=longer[0]) if alone else phrase

    def _without_verb(self, phrase: Phrase) -> Phrase:
        """Without the verb that follows a name in the sentence: "the vase can"."""
        found = words(phrase.text)
        if len(found) < 2 or found[-1] not in _MODALS:
            return phrase
        if any(found[-1] in thing.words for thing in self.things):
            return phrase
        return replace(phrase, text=" ".join(found[:-1]))

    def _named(self, phrase: Phrase, without: Collection[str]) -> Fits:
        described = describe_phrase(phrase)
        nouns = self._nouns(described, phrase, without)
        return self._qualified(described, nouns, phrase.quantity == "all")

    def _made_so(self, described: Description, without: Collection[str]) -> Fits:
        """What is declared to be of the material or the colour: "steel instruments" that none is."""
        if not described.materials and not described.colours:
            return []
        free = [t for t in self.things if t.name not in without]
        return [(t, COUNTS) for t in free if has_properties(t, described) >= LIKELY]

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
        for key, other in described.relations:
            kept = self._related(kept, key, other, many=many)
        if _REAL & set(described.whole):
            kept = [(t, s) for t, s in kept if not UNREAL & set(t.words)]
        for excluded in described.excluded:
            kept = self._excluding(kept, excluded)
        if described.side or described.superlative or described.ordinal:
            kept = extreme(kept, described, many)
        return kept

    def _excluding(self, kept: Fits, excluded: Description) -> Fits:
        phrase = Phrase(text=excluded.text, quantity="all")
        out = {thing.name for thing, _ in self._fitting(phrase, ())}
        if not excluded.vague:
            names = [t.name for t, _ in self._fitting(phrase, ()) if _ >= SETS]
            out = set(names) or out
        if not out:
            use = Phrase(text=f"things you can {excluded.text}", quantity="all")
            out = {thing.name for thing, _ in self._fitting(use, ())}
        if not out & {thing.name for thing, _ in kept}:
            said = {normal(each) for each in excluded.core}
            out = {t.name for t, _ in kept if said and said <= {normal(w) for w in t.words}}
        return [(thing, score) for thing, score in kept if thing.name not in out]

    def _stands_somewhere(self, described: Description) -> bool:
        """Whether it is told by another thing of the scene."""
        return any(self._fitting(Phrase(text=other), ()) for _, other in described.relations)

    def _related(self, kept: Fits, key: str, other: str, *, many: bool) -> Fits:
        """Those that stand so to the other thing."""
        anchors = self._fitting(self._without_verb(Phrase(text=_bare(other))), ())
        best = max((score for _, score in anchors), default=0.0)
        anchors = [pair for pair in anchors if pair[1] >= best - 0.015]
        if len(anchors) != 1:
            return kept
        anchor = anchors[0][0]
        kept = [pair for pair in kept if pair[0] is not anchor]
        if key in ("inside", "on"):
            return [pair for pair in kept if self.rests(pair[0].name, anchor.name)] or kept
        here = stands(anchor)
        placed = [(t, s) for t, s in kept if is_placed(t)]
        if not is_placed(anchor) or not placed:
            return kept
        if key == "near":
            return [min(placed, key=lambda pair: distance(pair[0], here))]
        axis, sign = AXES[key]
        beyond = [(t, s) for t, s in placed if sign * (stands(t)[axis] - here[axis]) > 0.005]
        if many or len(beyond) < 2:
            return beyond
        return [min(beyond, key=lambda pair: distance(pair[0], here))]

    def rests(self, name: str, place: str) -> bool:
        """Whether the one is in or on the other."""
        return any(Relation(key, (name, place)) in self.facts for key in ("in", "on"))


def _bare(text: str) -> str:
    found = words(text)
    return text if not found else re.sub(r"^(?:the|a|an|my|your)\s+", "", text, flags=re.I)
