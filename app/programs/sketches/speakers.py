"""What a speaker says that they or others do, which is no order: "and I'll see to that".

Each rule is one that English has; what no rule knows stays as it is.
"""

import re

from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list

ORDERING = word_list("ordering")
_MINE = r"(?:i|we)(?:'ll| will| can|'m going to| am going to|'d rather)(?: just| only)?"
_SEEN_TO = re.compile(
    rf",?(?: and| but| so|,) {_MINE} (?:see to|deal with|handle|sort|sort out|take care of|do|manage|look after|pack|carry|move|put away|take)"
    r" (?:it|that|this|those|them|these|that one|those ones|that bit|that lot)(?: out| away| all)?"
    r"(?: myself| ourselves| later| in a (?:bit|minute|moment)| tomorrow)*(?=\s*(?:[.,;!?]|$))",
    re.I,
)
"""The food's going in my bag and I'll see to that."""
_OTHERS = r"(?:i|we|he|she|they|everyone|everybody|people|mum|dad|the (?:kids|boys|girls|children|guests|others))"
_AFTERWARDS = re.compile(
    rf",?\s+(?:and )?then {_OTHERS}(?:'ll| will| can|'re going to| are going to|'m going to| am going to)"
    r" (?!need\b|want\b|like\b|have\b)[^.;:!?]*(?=[.;:!?]|$)",
    re.I,
)
"""..., then we'll take it from bar nine."""
_LEISURE = re.compile(
    r",?\s+(?:and )?then you (?:can|may) (?:go|rest|stop|relax|put your feet|have (?:a|the)|take (?:a|the rest))\b[^.;:!?]*(?=[.;:!?]|$)",
    re.I,
)
_SOMEBODY = (
    r"(?:it|he|she|they|someone|somebody|anyone|anybody|everyone|mum|mom|dad|gran|grandma|grandad|people|"
    r"(?:the|my|our|your|his|her) (?:[\w'-]+ ){0,2}?[\w'-]+)"
)
_BEFORE = re.compile(
    rf",? before {_SOMEBODY} (?!goes\b|is\b|gets\b|belongs\b|does\b|was\b|has\b|comes (?:in|on|out of) (?:the|my)\b)"
    r"(?!us\b|this\b|as\b|glass\b|its\b|yes\b|\w+(?:ss|us|'s)\b)"
    r"(?:(?<=they )\w+|(?<=people )\w+|\w+s)\b(?! (?:and|to) the\b)[^.;,:!?]*(?=[.,;:!?]|$)",
    re.I,
)
"""Shut it before the cat walks over it."""
_WHY = re.compile(
    r"(?P<out>\b(?:except(?: for)?|apart from|but(?: not)?|bar|other than|save(?: for)?|not|besides) (?:the|my|our|that|his|her) [\w' -]+?),"
    r" (?:that|which|it|that one|this one|he|she|they)(?: (?:needs?|wants?|has|have|must|still|is|are|was|can|can't|could|should|"
    r"belongs?|stays?|lives?|goes|does|doesn't|isn't|might|may|will|won't)|'s|'re|'ll|'ve)\b[^.,;:!?]*(?=[.;:!?]|$)",
    re.I,
)
"""... apart from the wardrobe, that needs airing."""
_OWNED = re.compile(
    r"(?:[,;]| \W)? ?(?:but|and|only|mind)?,? ?(?P<what>(?:the|that|this) [\w -]+?)(?:'s| is| are) "
    r"(?:mine|hers|his|ours|yours|theirs|not (?:mine|ours|yours)|(?:my|our|her|his) [\w']+'s|[A-Z]\w+'s),?"
    r" (?:so |and )?(?:please )?(?:(?:keep (?:your )?)?hands off|(?:leave|let) (?:it|them|that)(?: alone| be| there| where (?:it|they) (?:is|are))?|"
    r"(?:don't|do not) (?:you )?(?:touch|move|take)(?: it| them| that)?)(?: please)?(?=\s*(?:[.;!?]|$))",
)
"""The corkscrew's mine, so hands off."""
_PARTS = re.compile(r"(?<=[.!?;])\s+")


def without_doings(sentence: str) -> str:
    """The sentence without what its speaker or others do, and why something is left out."""
    text = _WHY.sub(r"\g<out>", _BEFORE.sub("", _LEISURE.sub("", _AFTERWARDS.sub("", sentence))))
    text = _OWNED.sub(lambda found: f". Leave {found['what']} alone", text).lstrip(". ")
    kept = [each for part in _PARTS.split(text) if (each := _ordered(part))]
    return " ".join(kept) or sentence


def _ordered(part: str) -> str:
    """The part, or nothing where it is about what the speaker sees to."""
    match = _SEEN_TO.search(part)
    if match is None:
        return part
    begun = set(words(part[: match.start()])[:3])
    return part[: match.start()] + part[match.end() :] if begun & ORDERING else ""
