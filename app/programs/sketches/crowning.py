"""What a pile is finished with: "the book crowning the pile", "finish it off with the rose"."""

import re
from collections.abc import Sequence

from app.programs.sketches.mentions import Mention

_LOT = r"(?:it|them|that|this|everything|things|the (?:pile|stack|tower|heap|lot|whole thing|whole lot|cake))"
_OVER_ALL = re.compile(
    rf"^(?: one)?(?: (?:is|goes|comes|sits))? (?:crowning|to crown|topping|to top|finishing|to finish|capping|to cap)"
    rf"(?: {_LOT})?(?: all)?(?: off)?(?=\s*(?:[.,;:!?]|$)| (?:and|because|so|please)\b)|"
    r"^(?: one)?(?: (?:is|goes|comes|sits))?(?: right| last)? (?:on|at)(?: the)?(?: very)? top"
    rf"(?: of (?:it all|them all|everything|the (?:pile|lot|stack|tower|heap)))(?=\s*(?:[.,;:!?]|$)| (?:and|because|so|please)\b)",
    re.I,
)
_WITH = re.compile(
    rf"\b(?:finish|top|crown|cap|complete|round)(?:ing|ed)?(?: {_LOT})?(?: all)?(?: off)? (?:with|by adding)"
    r"(?: the| a| an| my)? $",
    re.I,
)


def crown(text: str, found: Sequence[Mention]) -> Mention | None:
    """The one thing that comes onto all others, where the sentence says so and names it once."""
    told = [
        each
        for each in found
        if _OVER_ALL.search(text[each.end :]) or _WITH.search(text[: each.start])
    ]
    names = [each.name for each in found]
    return told[0] if len(told) == 1 and names.count(told[0].name) == 1 else None
