"""So many of a kind that stay, and the number of the others: what is asked for is that number."""

import re

from app.programs.knowledge.classes import normal
from app.programs.knowledge.names import NUMBERS

_NUMBER = "|".join((*NUMBERS, "[2-9]"))
_SO_MANY = re.compile(
    r"\b(?:leave|keep|save|spare|reserve|hold back|set aside|(?:i|we)(?: only| just)? (?:need|want))(?: (?:me|us|him|her))?(?: just| only| out| back)* "
    rf"(?:{_NUMBER}|an?) (?:of (?:the|my|those|these) )?(?P<noun>[\w-]+(?: [\w-]+)??)"
    r"(?: (?:to|for|so|out|behind|back|here|there|handy|aside|where|on|in|with)\b[^.,;!?]*?)?"
    r"[,;.]? (?:(?:and|but|then) )*(?P<deed>[a-z]+(?: away)?) (?:the )?(?:other|remaining|last) (?P<others>one|two|three|four|five|six|seven|eight|[2-9])"
    r"(?: ones)?(?= (?:in|into|inside|on|onto|away|back|to)\b)",
    re.I,
)
"""Leave me one notebook to scribble in and put the other two in the drawer."""


def counted_off(sentence: str) -> str:
    """The sentence with only the number that something is to be done with."""

    def told(found: re.Match[str]) -> str:
        noun = found["noun"]
        if found["others"].lower() == "one":
            return f"{found['deed']} one {normal(noun)}"
        several = noun if normal(noun) != noun.lower() else f"{noun}s"
        return f"{found['deed']} {found['others']} {several}"

    return _SO_MANY.sub(told, sentence)
