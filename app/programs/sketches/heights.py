"""In which order things of several sizes are piled up, as the sentence tells it."""

import re

from app.programs.knowledge.word_lists import word_list

_SIZE = (
    r"(?:the )?(?:very )?(?P<size>big|larg|tall|wid|heav|long|broad|thick|small|tin|short|narrow|light|littl|thin)"
    r"(?:g?e?st|e|er|iest|ny|le|y)?(?: one| \w+)?"
)
_LARGE = ("big", "larg", "tall", "wid", "heav", "long", "broad", "thick")
_BELOW = (
    rf"{_SIZE} (?:\w+ ){{0,3}}?(?:lowest|undermost|(?:at|on|to|as|is|forms?|makes?)(?: the)?(?: very)? (?:bottom|base|foundation))\b",
    rf"\b(?:bottom|base|foundation)(?: is| goes| comes|:|,)? {_SIZE}",
)
_ABOVE = (
    rf"{_SIZE} (?:\w+ ){{0,3}}?(?:uppermost|topmost|highest|(?:on|at|to)(?: the)?(?: very)? top\b(?! of the))",
    rf"\btop (?:it|them)(?: off)? with {_SIZE}",
    rf"{_SIZE} (?:\w+ )?last\b",
)
_FIRST = (
    rf"\b(?:start|begin)(?:ning|ing|s)? (?:with|from) {_SIZE}",
    rf"{_SIZE} (?:\w+ )?first\b",
)
_PILING = word_list("piling")


def piled(order: str | None, sentence: str) -> str | None:
    """The order that the sentence of a pile plainly tells, the lowest first; else the one that is given."""
    if not _PILING & set(re.findall(r"\w+", sentence.lower())):
        return order
    for patterns, below in ((_BELOW, True), (_ABOVE, False), (_FIRST, True)):
        for pattern in patterns:
            if match := re.search(pattern, sentence, re.I):
                return (
                    "largest first"
                    if (match["size"].lower() in _LARGE) is below
                    else "smallest first"
                )
    return order
