"""Which of the world's actions that are not on offer would do what a sentence asks for."""

import re
from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.errors import TaskDeclined
from app.programs.knowledge.names import stem, words
from app.programs.sketches.order import said_in
from app.programs.sketches.verbs import HANDING

_BESIDE = r"\b(?:next to|beside|alongside|close to|near)\b"
_SAYING = {
    "handover": HANDING.pattern,
    "place_left_of": rf"\bleft(?:[- ]hand)?(?: side)? of\b|{_BESIDE}",
    "place_right_of": rf"\bright(?:[- ]hand)?(?: side)? of\b|{_BESIDE}",
    "place_behind": rf"\bbehind\b|{_BESIDE}",
    "place_in_front_of": rf"\bin front of\b|{_BESIDE}",
    "place_at": r"\b(?:swap|exchange|switch)\b|\b(?:back|off|out|undo|rückgängig)\b|\d",
    "wipe": r"\b(?:wipe|clean|scrub|polish|dust|mop|rub)\b",
    "pour": r"\b(?:pour|empty|fill)\b",
    "open": r"\bopen\b",
    "close": r"\b(?:close|shut)\b",
    "push": r"\b(?:push|shove|nudge|slide)\b",
    "stack": r"\b(?:stack|pile|tower)\b",
    "upright": r"\bupright\b|\bstand .+ up\b",
    "pick": r"\b(?:pick up|lift|hold)\b",
}
"""What somebody says who wants the action of this name done."""


def with_offer(
    declined: TaskDeclined, sentence: str, others: Sequence[ActionSignature]
) -> TaskDeclined:
    """The refusal, telling how what is impossible would become possible, where it would."""
    names = [each.name for each in others if _asked(each.name, sentence)]
    if declined.kind != "impossible" or not names:
        return declined
    which = ", ".join(names)
    them = "it" if len(names) == 1 else "one of them"
    return TaskDeclined(
        f"{declined.reason}; {which} could: list {them} in the scene's actions",
        kind=declined.kind,
        question=declined.question,
        choices=declined.choices,
        prompt=declined.prompt,
        completion=declined.completion,
    )


def _asked(action: str, sentence: str) -> bool:
    saying = _SAYING.get(action)
    if saying:
        return bool(re.search(saying, sentence, re.I))
    return said_in(action, {stem(each) for each in words(sentence)})
