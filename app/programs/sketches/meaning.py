"""What a thing is told by in other words than its name: its use, a wish, or the situation."""

import re
from collections.abc import Callable, Collection, Sequence

from app.programs.knowledge.classes import VAGUE, normal
from app.programs.knowledge.names import plain, words
from app.programs.knowledge.uses import uses
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.description import Description
from app.programs.sketches.matching import COUNTS, KIND, SETS, fit, misspelt
from app.programs.sketches.qualities import Fits
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import Thing

Judge = Callable[[str, Sequence[Sequence[str]]], Sequence[float]]
"""For words that no knowledge at hand covers: how like each thing is to them, up to 1; a thing is
told by its name and by what it is for."""
ALIKE, ALIKE_MARGIN = 0.45, 0.05
"""Likeness of meaning, a cosine, from which words are taken to mean a thing."""
PLAINLY, USE_MARGIN = 0.6, 0.06
"""From which likeness on a clause tells plainly what is meant, before any class is asked; of
several things that are meant, how far one may stay behind the likeliest."""
SITUATED, LEAD = 0.35, 0.1
"""The likeness to a situation that is told beside, and how far the likeliest has to be ahead."""
BARELY = 0.025
"""The same where the words say that the situation tells which one is meant."""
_REQUISITE = re.compile(
    r"\b(?:necessary|right|proper|appropriate|requisite|required|needed|correct|relevant|suitable|obvious) "
    r"(?:implement|tool|utensil|gadget|device|instrument|thing|item|object|piece of equipment|kit|article)\b",
    re.I,
)
_WISH = re.compile(
    r"\b(?:what(?:ever)?|(?:some|any)thing|the (?:thing|one|object|item|tool|implement|gadget|device))"
    r"(?:'s gonna|'s going to|'ll)?(?: that| which)? (?:(?:i|you|we|people|one|they|he|she|to|for)\b|\w+s (?:you|me|us|one|the|my|your|that|this|his|her|it)\b|"
    r"(?:will|would|can|could|might|helps?|is going to|is gonna|keeps?|gets?|makes?)\b)"
    r"[^,.;:!?]*?"
    r"(?=,|\.|;|:|!|\?| should | must | goes? | belongs? | needs? | wants? | has | is | in the | into | on the )",
    re.I,
)
_OF_ALL = word_list("of all")
"""A sentence with one of these may mean everything there is."""
_SEEN = frozenset(("see", "find", "have", "got", "left", "right", "like", "there"))
"""Verbs of clauses that tell no use."""
_SPOKEN_OF = frozenset(
    ("talked", "spoke", "spoken", "mentioned", "discussed", "agreed", "promised", "remember")
)
"""Verbs of clauses about what was said some other time."""
_WHATEVER = frozenset(("whatever", "everything", "anything", "all", "things"))
_CLAUSE_WORDS = frozenset(("for", "to", "that", "which", "you", "i", "we", "with", "made", "used"))
_SAID_OF_ALL = word_list("said of all")
"""Words of a clause that tell one thing from another as little as "thing" does."""
_NEEDING = word_list("needing")
"""Verbs of a clause that leave it to the rest of the sentence what is needed."""


class Meaning:
    """Finds the things of a scene that are told by what they are for."""

    def __init__(self, things: Sequence[Thing], sentence: str, judge: Judge | None) -> None:
        self._things = things
        self._sentence = sentence
        self._judge = judge

    def plainly(self, described: Description, phrase: Phrase, without: Collection[str]) -> Fits:
        """The things a clause plainly tells of by their use: "the thing i dry my hair with"."""
        if not is_clause(described) or _tells_nothing(described):
            return []
        scores = self._likenesses(described, without)
        best = max((likely for likely, _ in scores), default=0.0)
        if best < PLAINLY:
            return []
        several = phrase.quantity == "all" or _WHATEVER & set(words(self._sentence))
        likeliest = next(thing for likely, thing in scores if likely == best)
        classed = self._classed(described, without)
        if several and likeliest in classed:
            return []
        member = max((likely for likely, thing in scores if thing in classed), default=0.0)
        if not several and likeliest not in classed and best < member + LEAD:
            return []  # One writes with a pen, however like writing a notebook is.
        least = max(PLAINLY, best - USE_MARGIN) if several else best
        return [(thing, KIND) for likely, thing in scores if likely >= least]

    def perhaps(self, described: Description, without: Collection[str]) -> Fits:
        """By likeness of meaning, for descriptions and for words that no knowledge covers."""
        open_ = set(described.whole) & VAGUE or all(map(misspelt, described.core))
        if not described.core or not (open_ or is_clause(described)) or _tells_nothing(described):
            return []
        if found := self._called_for(described, without):
            return found
        scores = self._likenesses(described, without)
        best = max((likely for likely, _ in scores), default=0.0)
        least = max(ALIKE, best - ALIKE_MARGIN)
        found = [(thing, COUNTS) for likely, thing in scores if likely >= least]
        if found or not is_clause(described):
            return found
        return self._ahead(scores) or self._told_by(self._sentence, without)

    def wished(self, described: Description, without: Collection[str]) -> Fits:
        """What a clause tells of of which the words are a part: "what i use to look at the specimens"."""
        said = set(words(described.text))
        clauses = (match[0] for match in _WISH.finditer(self._sentence))
        clause = next((each for each in clauses if said <= set(words(each))), None)
        return self._told_by(clause, without) if clause else []

    def told_in_passing(self, described: Description, without: Collection[str]) -> Fits:
        """For nothing but "things": what the sentence's one clause of a use tells of."""
        told = described.colours or described.materials or described.sizes or described.side
        clauses = [match[0] for match in _WISH.finditer(self._sentence)]
        said = set(words(self._sentence))
        if told or described.excluded or len(clauses) > 1 or (not clauses and said & _OF_ALL):
            return []
        if clauses and _SEEN & set(words(clauses[0])):
            return []
        found = self._told_by(clauses[0], without) if clauses else []
        return found or self._told_by(self._sentence, without)

    def tells_one(self, described: Description, things: Sequence[Thing]) -> Thing | None:
        """Of things that fit alike, the one that the words no name has tell of: the bendy fruit."""
        named = {normal(word) for thing in things for word in thing.words}
        telling = [
            w for w in described.core[:-1] if normal(w) not in named | VAGUE and w != "other"
        ]
        if self._judge is None:
            return None
        if _REQUISITE.search(self._sentence):
            return self._requisite(things)
        if not telling:
            return None
        scores = self._judge(described.text, [(each.name, *uses(each.name)) for each in things])
        ahead = self._ahead(list(zip(scores, things, strict=True)))
        return ahead[0][0] if ahead else None

    def _requisite(self, things: Sequence[Thing]) -> Thing | None:
        """Of these, what the rest of the sentence calls for: "the necessary tool"."""
        told = _REQUISITE.sub("", self._sentence)
        clauses = [each for each in re.split(r"[;:.!?\u2014]+", told) if each.strip()]
        if self._judge is None or not clauses:
            return None
        scores = self._judge(clauses[0], [(each.name, *uses(each.name)) for each in things])
        (second, _), (best, thing) = sorted(zip(scores, things, strict=True), key=lambda s: s[0])[
            -2:
        ]
        return thing if best >= max(SITUATED, second + BARELY) else None

    def _called_for(self, described: Description, without: Collection[str]) -> Fits:
        """What a situation calls for: "rain is forecast; pack what I will need"."""
        said = words(described.text)
        if self._judge is None or set(said) - VAGUE - _SAID_OF_ALL - _NEEDING:
            return []
        clauses = re.split(r"[;:.,!?\u2014]+", self._sentence)
        beside = [each for each in clauses if not set(said[1:]) <= set(words(each))]
        told = " ".join(" ".join(beside).split())
        return self._told_by(told, without) if told else []

    def _told_by(self, told: str, without: Collection[str]) -> Fits:
        """The one thing that the words tell of before all others, if there is one."""
        said = plain(self._sentence)
        free = [t for t in self._things if t.name not in without and t.unmarked not in said]
        if self._judge is None or len(free) < 2:
            return []
        scores = self._judge(told, [(thing.name, *uses(thing.name)) for thing in free])
        (second, _), (best, thing) = sorted(zip(scores, free, strict=True), key=lambda s: s[0])[-2:]
        return [(thing, COUNTS)] if best >= max(SITUATED, second + LEAD) else []

    def _ahead(self, scores: list[tuple[float, Thing]]) -> Fits:
        """The likeliest, where it is well ahead of all others."""
        ordered = sorted(scores, key=lambda each: each[0])
        if len(ordered) < 2 or ordered[-1][0] < max(SITUATED, ordered[-2][0] + LEAD):
            return []
        return [(ordered[-1][1], COUNTS)]

    def _classed(self, described: Description, without: Collection[str]) -> list[Thing]:
        """The things of a class that the words describe: it is asked where it knows the likeliest."""
        return [t for t in self._things if t.name not in without and fit(t, described) >= SETS]

    def _likenesses(
        self, described: Description, without: Collection[str]
    ) -> list[tuple[float, Thing]]:
        """How like each thing is to what is said of it; what the words name besides is not meant."""
        said = " ".join(normal(each) for each in words(described.text)[1:])
        free = [
            thing
            for thing in self._things
            if thing.name not in without and f" {thing.unmarked} " not in f" {said} "
        ]
        if self._judge is None or not free:
            return []
        told = [(thing.name, *uses(thing.name)) for thing in free]
        bare = " ".join(each for each in words(described.text) if each not in VAGUE | _SAID_OF_ALL)
        scores = zip(
            self._judge(described.text, told),
            self._judge(bare or described.text, told),
            strict=True,
        )
        return [(max(pair), thing) for pair, thing in zip(scores, free, strict=True)]


def _tells_nothing(described: Description) -> bool:
    """Whether only who was there could know: "the one we talked about yesterday"."""
    return bool(_SPOKEN_OF & set(words(described.text)))


def is_clause(described: Description) -> bool:
    """Whether the words tell what a thing is for, and do not name it."""
    said = words(described.text)
    told = described.materials or described.colours or described.relations or described.side
    begun = {each.partition("'")[0] for each in said[1:]}
    return len(said) > 2 and not told and bool(_CLAUSE_WORDS & begun)
