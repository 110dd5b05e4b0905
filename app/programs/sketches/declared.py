"""What the scene declares its things to be, where that tells what a word for them takes in."""

from app.programs.knowledge.classes import ThingClass, normal
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.synonyms import mean_the_same
from app.programs.knowledge.wordnet import nouns
from app.programs.sketches.description import Description
from app.programs.sketches.matching import COUNTS, HEAD, find_class
from app.programs.sketches.qualities import Fits
from app.programs.sketches.things import Thing


def as_declared(found: Fits, described: Description) -> Fits:
    """Where the scene declares some to be what is wanted, without what it declares to be another thing."""
    wanted = normal(" ".join(described.core))
    declared = [pair for pair in found if normal(pair[0].item.category or "") == wanted]
    if not declared:
        return found
    kind = find_class(wanted)
    return [
        (thing, max(score, HEAD) if (thing, score) in declared else score)
        for thing, score in found
        if (thing, score) in declared or not _is_other(thing, wanted, kind)
    ]


def _is_other(thing: Thing, wanted: str, kind: ThingClass | None) -> bool:
    """Whether its declared category is neither a wider nor a narrower word for what is wanted."""
    category = normal(thing.item.category or "")
    if category in ("", "object") or mean_the_same(category, wanted):
        return False
    wider = find_class(category)
    if kind and kind.name == wanted and belonging(category, kind) >= COUNTS:
        return False
    if wider and belonging(wanted, wider) >= COUNTS:
        return False
    return max(nouns().kind_of(category, wanted), nouns().kind_of(wanted, category)) < KINDRED


KINDRED = 0.5
"""From which share of WordNet's meanings on a word is a kind of another."""
