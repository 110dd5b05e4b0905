"""Asides in other languages: what a speaker says of themselves, "je la porte ce soir", is no order."""

import re

_I = r"(?:je|ich|ik|yo|eu|io|wir|nous|on)"
_WISH = (
    r"(?:voudrais|veux|aimerais|souhaite|m\u00f6chte|moechte|will|h\u00e4tte|haette|w\u00fcrde|wuerde|brauche|ben\u00f6tige|wil|wou|zou|"
    r"graag|quiero|quisiera|voglio|vorrei|quero|queria|voudrions|voulons|wollen|m\u00f6chten|gern|gerne|n'en veux|besoin|bitte)"
)
_REASON = re.compile(
    rf"(?:,|;| [\u2014\u2013-])\s+(?:(?:denn|car|weil|parce que|puisque|want|omdat|porque|perch\u00e9|j\u00e1 que) )?"
    rf"(?:(?:{_I}\b|j')(?![^,.;:!?]*\b{_WISH}\b)|(?:die|den|das|de|het|dat) \w+ {_I}\b(?![^,.;:!?]*\b(?:in|auf|op) (?:die|den|das|de|het)\b))"
    r"[^,.;:!?]*(?=[.;:!?]|$)",
    re.I,
)
_IN_IT = re.compile(
    r"\b(?P<deed>mets|mettez|pose|posez|glisse|glissez|range|rangez|place|placez|verse|versez|jette|jetez)-y (?P<what>[^,.;:!?]+?)(?=\s*(?:[,.;:!?]|$)| (?:et|mais|puis|sauf)\b)",
    re.I,
)
"""Mets-y le collier: into what was just spoken of."""


def without_reasons(sentence: str) -> str:
    """The sentence without what its speaker says of themselves, and "mets-y" as two words."""
    return _IN_IT.sub(r"\g<deed> \g<what> dedans", _REASON.sub("", sentence.replace("\u2019", "'")))
