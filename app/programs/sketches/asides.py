"""What people say besides what they want: places they thought of first, and what they are not done with.

Each rule is one that English has; what no rule knows stays as it is.
"""

import re

from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list

ORDERING = word_list("ordering")
MOST_WORDS = 5
"""Of a place."""

_THOUGHT = re.compile(
    r"(?:\b(?:and|now|well),? )?\b(?:i (?:was|were) (?:just )?(?:going to|gonna|about to) (?:say|suggest|ask for|go for|have you put (?:it|them) (?:in|on))|"
    r"i was thinking(?: of)?|i (?:nearly|almost) said|i(?:'d| would) have said|(?:normally|usually) i(?:'d| would) say)"
    r" [^.;!?]*?,? (?:but|only|except)\b [^.;!?]*?,? (?:so|let's)(?: please| just)?(?: go and)? "
    r"(?=(?:put|pop|stick|place|move|set|lay|hang|use|make|chuck|drop|shove|leave|close|open)\b)",
    re.I,
)
"""I was going to say the drawer, but it is full, so put it on the tray."""
_INSTEAD = re.compile(r",? instead(?=[.,;!?]|$)", re.I)
_IT_ALL = re.compile(
    r"(?<!\band )(?<!\bthen )\b(?P<deed>put|pack|pop|chuck|stick|throw|bung|shove|sling|dump|load|tidy|move|get|stuff|tip|bring|take|place)"
    r" (?:(?:it|this|that) all|(?:the|this) (?:whole )?(?:lot|caboodle|shebang))"
    r"(?= (?:away |back |down |over |straight )?(?:in|into|inside|on|onto|to|except|bar|but)\b)",
    re.I,
)
_OVER_TO = re.compile(
    r"\b(?P<deed>(?:push|shove|nudge|shift|slide|scoot|prod|knock|roll|poke)\b[^.,;:!?]*?) (?:over|across|along) to "
    r"(?=(?:the|my|your|that|this|our)\b)",
    re.I,
)
_NOT_DONE = re.compile(
    r"^(?:i|we|he|she|they)(?:'m| am|'re| are|'ve| have|'s| is| has)?(?:n't| not)(?: quite| yet| really)? "
    r"(?:finished|done)(?: with| using| reading) (?P<what>[^.!?;]+)[.!]?$|"
    r"^(?:i|we|he|she|they)(?:'m| am|'re| are|'s| is) still (?:using|on|working on|reading|busy with) (?P<what2>[^.!?;,]+)[.!]?$",
    re.I,
)
"""I haven't finished with the suitcase."""
_THAT_ONE = re.compile(
    r"^(?:that one|this one|it|those|them|these|that)\b,?(?: (?:or|and|nor)(?: with)? )?", re.I
)
_LEFT_OPEN = re.compile(
    r"(?:\b(?:somebody|someone|who|you|he|she|they|we|i|(?:my|our|his|her|your|the) (?:[\w-]+ ){0,2}?[\w-]+)(?:'s|'ve| has| have)?(?: gone and| been and)? )?\bleft (?P<what>(?:the|my|our|your|that|this) [^.,;!?]+?) (?:wide )?(?:open|ajar|unlocked)(?: again)?[.!?;,]\s*"
    r"(?:(?:so|please|now|go and|could you|can you|would you)[, ]+)*(?P<deed>shut|close) (?:it|that)\b",
    re.I,
)
"""Somebody left the hen house open. Shut it."""
_THEN_TOO = re.compile(
    r"\b(?P<deed>open|close|shut|push) (?P<one>(?:the|my) [\w' -]+?),? (?:and )?then (?P<other>(?:the|my) [\w' -]+?)"
    r"(?=[.!?]|$)",
    re.I,
)
"""Open the chest, then the case."""
_BOTH = re.compile(
    r"\b(?P<deed>open|close|shut)(?: up)? (?P<one>(?:the|my|our) [\w'-]+(?: [\w'-]+)?) and (?P<other>(?:the|my|our) [\w'-]+(?: [\w'-]+)?)"
    r"(?=,? (?:and )?then\b|[.;!?]|$)",
    re.I,
)
"""Open the chest and the case, then ..."""
_PLACE = re.compile(
    r"\b(?:the|that) (?:place|spot|bit|part|one) where (?=(?:the|my|our|your|we|i|you|he|she|they|one|people)\b)",
    re.I,
)
_ASKED = re.compile(
    r"^what (?:do|would|should|can|could) (?P<use>(?:i|you|we|one|they) [^?.!,]+?)\? "
    r"(?:(?:right|well|ok|okay|exactly|yes|good|correct|that)\b[.,!:]? )*(?P<where>(?:(?:in|into|on|onto) )?[^.,?!]+?)(?: with (?:it|that))?(?P<end>,? please)?(?=[.!?]|$)",
    re.I,
)
"""What do we dig with? Right. Wheelbarrow, please."""
_PARTS = re.compile(r"(?<=[.!?;])\s+")


def without_thoughts(sentence: str) -> str:
    """The sentence with what it asks for in the end, and what is still in use told to be left."""
    text = _OVER_TO.sub(r"\g<deed> to ", _IT_ALL.sub(r"\g<deed> everything", sentence))
    text = _PLACE.sub("the thing where ", _LEFT_OPEN.sub(r"\g<deed> \g<what>", text))
    text = _THEN_TOO.sub(
        lambda found: (
            f"{found['deed']} {found['one']} and then {found['deed'].lower()} {found['other']}"
        ),
        text,
    )
    text = _BOTH.sub(
        lambda found: (
            f"{found['deed']} {found['one']} and {found['deed'].lower()} {found['other']}"
        ),
        text,
    )
    text = _ASKED.sub(_answered, text)
    if _THOUGHT.search(text):
        text = _INSTEAD.sub("", _THOUGHT.sub("", text))
    parts = _PARTS.split(text)
    if len(parts) < 2:
        return text
    return " ".join(each for each in map(_left, parts) if each)


def _answered(match: re.Match[str]) -> str:
    """The thing that a question asks for, to the place that follows: the asker knows which it is."""
    where = match["where"]
    if ORDERING & set(words(where)) or len(words(where)) > MOST_WORDS:
        return match[0]
    link = "" if re.match(r"(?:in|into|on|onto) ", where, re.I) else "on the "
    return f"put the thing {match['use']} {link}{where[0].lower()}{where[1:]}{match['end'] or ''}"


def _left(part: str) -> str:
    """The part of a sentence as an order to leave something, where it says that somebody is not done with it."""
    match = _NOT_DONE.match(part)
    if match is None:
        return part
    what = _THAT_ONE.sub("", match["what"] or match["what2"])
    return f"Leave {what} alone." if what else ""
