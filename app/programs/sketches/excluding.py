"""What words for an exception take out of a set: "but not the kiwi", "that is not red"."""

from collections.abc import Callable, Collection

from app.programs.knowledge.classes import normal
from app.programs.sketches.matching import SETS, UNMARKED
from app.programs.sketches.phrase import Description
from app.programs.sketches.qualities import Fits
from app.programs.sketches.sketch import Phrase

Fitting = Callable[[Phrase, Collection[str]], Fits]
"""The things of the scene that fit a phrase, without those of the names."""


def without_excluded(kept: Fits, excluded: Description, fitting: Fitting) -> Fits:
    """Those that the words for the exception do not fit."""
    phrase = Phrase(text=excluded.text, quantity="all")
    found = fitting(phrase, ())
    out = {thing.name for thing, _ in found}
    if not excluded.vague and max((score for _, score in found), default=0.0) >= UNMARKED:
        # Its name: with the lamp, no candle stays, which is a lamp of a kind.
        out = {thing.name for thing, score in found if score >= UNMARKED}
    elif not excluded.vague:
        out = {thing.name for thing, score in found if score >= SETS} or out
    if not out:
        use = Phrase(text=f"things you can {excluded.text}", quantity="all")
        out = {thing.name for thing, _ in fitting(use, ())}
    if not out & {thing.name for thing, _ in kept}:
        said = {normal(each) for each in excluded.core}
        out = {t.name for t, _ in kept if said and said <= {normal(w) for w in t.words}}
    return [(thing, score) for thing, score in kept if thing.name not in out]
