"""What is spoken of and then called "all of it", which is the fish after "the fish must stay cold"."""

import re

from app.programs.knowledge.names import words
from app.programs.sketches.rereading import ORDERING

_TOPIC = re.compile(
    r"^(?:well,? |right,? |so,? |look,? )?(?P<what>(?:the|my|our|your|those|these|all the) (?!other\b|rest\b)[\w'-]+(?: (?!has\b|have\b|must\b|is\b|are\b|was\b|were\b)[\w'-]+){0,2}?)"
    r"(?: (?:has|have|had|must|is|are|was|were|needs?|needed|should|can't|cannot|won't|wants?|looks?|smells?|gets?|keeps?|came|comes?|went|arrived)|'s|'ve|'re|n't)\b[^.!?;:]*[.!?;:]$",
    re.I,
)
_ALL_OF_IT = re.compile(
    r"\b(?:all|every (?:one|bit|last one|last bit|single one)|each(?: one)?|the (?:whole )?lot) of (?:it|them|those|that)\b(?! (?:in|on) the (?:middle|left|right)\b)|"
    r"\b(?:it|them|those) all\b",
    re.I,
)
_PARTS = re.compile(r"(?<=[.!?;:])\s+")


def named_whole(sentence: str) -> str:
    """The sentence with the name of what was spoken of just before in place of "all of it"."""
    parts = _PARTS.split(sentence)
    for i, part in enumerate(parts[1:], 1):
        topic = _TOPIC.match(parts[i - 1])
        if topic and ORDERING & set(words(part)[:4]) and not _TOPIC.match(part):
            noun = re.sub(
                r"^(?:the|my|our|your|those|these|all the) ", "", topic["what"], flags=re.I
            )
            parts[i] = _ALL_OF_IT.sub(f"all the {noun}", part, 1)
    return " ".join(parts)
