"""Turns of phrase that say a plain thing in a roundabout way → the plain way, for the model that reads it.

Each rule is one that English has; what no rule knows stays as it is.
"""

import re

from app.programs.knowledge.names import plain, singular

_PLACING = r"(?:in|into|inside|on|onto|to)"
_CORRECTION = re.compile(
    rf"\b({_PLACING}) (?:the|my|your|that|this) [\w' -]{{1,40}}?\s*(?:,|\.\.\.|\u2026|\u2014|-)+\s*"
    r"(?:(?:that is|that's|i mean|i meant|or rather|rather|no|sorry|wait|make that|i\.e\.)[, ]+)+"
    rf"(?:{_PLACING} )?(?=(?:the|my|your|that|this)\b)",
    re.I,
)
"""In the left basket, I mean, the rattan one."""
_GIVEN = re.compile(
    r"\bgive (?P<what>(?:the|my|your|that|this|both|all)\b[^,.;]*?) an? (?:\w+ )?"
    r"(?P<deed>push|shove|nudge|prod|wipe|stir|shake|rinse|wash|pull|twist|polish|clean|brush|press)\b",
    re.I,
)
_DEEDS = {"shove": "push", "nudge": "push", "prod": "push"}
_ONLY = re.compile(r",? and only (?:the )?[\w-]+,?(?= )", re.I)
_INTRODUCED = re.compile(
    r"^(?P<before>(?:.*[.!?:;] )?)(?:there(?: are|'re| is|'s)|here are|of (?:the|my|our|your|these|those)|"
    r"you(?:'ll)? (?:see|have)|i(?:'ve| have)(?: got)?) "
    r"(?:all )?(?:two|three|four|five|six|several|some|a few|a pair of|a row of) (?:\w+ )?"
    r"(?P<noun>[a-z-]+s|mice|knives|shelves|loaves)\b[^.,:;!?]*[.,:;!?]\s+",
    re.I,
)
_ONE = re.compile(r"\b(the (?:very )?[\w-]+) one\b", re.I)
_OTHER = re.compile(r"\bthe other\b(?! \w+s? (?:goes|belongs|in|into|on|onto|is)\b)", re.I)


def rephrased(sentence: str) -> str:
    """The English sentence without corrections, gifts of a push, and introductions."""
    text = _CORRECTION.sub(r"\1 ", sentence)
    text = _GIVEN.sub(lambda found: f"{_deed(found['deed'])} {found['what']}", text)
    text = _ONLY.sub("", text)
    return _introduced(text)


def _deed(word: str) -> str:
    return _DEEDS.get(word.lower(), word.lower())


def _introduced(text: str) -> str:
    """``There are three cups in a row: the middle one …`` → ``the middle cup …``."""
    match = _INTRODUCED.match(text)
    if match is None:
        return text
    rest = text[match.end() :]
    if not _ONE.search(rest):
        return text
    noun = singular(plain(match["noun"]))
    rest = _OTHER.sub(f"the other {noun}", _ONE.sub(rf"\1 {noun}", rest))
    return match["before"] + rest
