"""Whether a sentence leaves it open which one of several is taken: "a cup", "one is enough"."""

import re

_INDEFINITE = (
    r"(?:an?|any|one|some|another|either|ein(?:e[nmrs]?)?|une?|una?|uno|uma?|eene?|irgendein\w*)"
    r"(?: of the| of these| of those| single| of)?"
)


_ANY_WILL_DO = re.compile(
    r"\b(?:one(?: thing| of them)?|just one|any(?: one)?(?: of them)?|either(?: one| of them)?) "
    r"(?:is|will|would|'ll) (?:be )?(?:plenty|enough|sufficient|do|fine)\b|"
    r"\b(?:doesn't|does not|don't|do not) (?:matter|mind|care) which\b|\bno matter which\b",
    re.I,
)
"""One thing is plenty."""


def any_one(text: str, sentence: str) -> bool:
    """Whether any one of the things of these words will do."""
    if _ANY_WILL_DO.search(sentence):
        return True
    spoken = r"\s+".join(map(re.escape, text.split()))
    return bool(re.search(rf"\b{_INDEFINITE}\s+{spoken}", sentence, re.I))
