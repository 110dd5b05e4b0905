"""Which of the world's actions that are not on offer would do what a sentence asks for."""

import re
from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.errors import TaskDeclined
from app.programs.knowledge.names import stem, words
from app.programs.sketches.order import said_in


def with_offer(
    declined: TaskDeclined, sentence: str, others: Sequence[ActionSignature]
) -> TaskDeclined:
    """The refusal, telling how what is impossible would become possible, where it would."""
    names = [each.name for each in others if _asked(each, sentence)]
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


def _asked(action: ActionSignature, sentence: str) -> bool:
    if action.said:
        return bool(re.search(action.said, sentence, re.I))
    return said_in(action.name, {stem(each) for each in words(sentence)})
