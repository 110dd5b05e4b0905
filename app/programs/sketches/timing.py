"""When something is to be done or stays so, behind a place: "on the charging shelf overnight"."""

import re

_TIME = (
    r"(?:overnight|tonight|tomorrow|today|for now|for the (?:night|day|weekend|moment|time being|winter|summer)|"
    r"(?:this|by|until|till) (?:morning|evening|afternoon|tomorrow|tonight|monday|friday|then)|all (?:night|day)|"
    r"straight away|right away|right now|at once|in the (?:meantime|meanwhile)|meanwhile|at the double|asap|"
    r"for safe ?keeping|for good)"
)
_BEHIND_PLACE = re.compile(
    r"(?P<place>\b(?:in|into|inside|on|onto) (?:the|my|our|your|that|this|its|their) [\w' -]+?),? "
    rf"{_TIME}(?=\s*(?:[.,;:!?]|$)| (?:and|but|while|because|so|as|please)\b)",
    re.I,
)
_WHERE = re.compile(
    r"\b(?:(?:over|across|along|up|down) )?(?P<link>to|towards|near|next to|beside|by) where "
    r"(?P<what>(?:the|my|our|your) [\w' -]+?) (?:is|are|stands?|sits?|lives?|lies?|hangs?)\b(?: now| kept)?",
    re.I,
)
"""Across to where the scales are."""


def timeless(sentence: str) -> str:
    """The sentence with bare places: without when, and without that something is there."""
    return _WHERE.sub(r"\g<link> \g<what>", _BEHIND_PLACE.sub(r"\g<place>", sentence))
