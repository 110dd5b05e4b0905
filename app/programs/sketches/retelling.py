"""What the words plainly tell of what goes where, in place of what a sketch made of it."""

from collections.abc import Iterable, Mapping, Sequence

from app.domain.action import ActionSignature
from app.domain.program import ActionCall
from app.programs.sketches.sketch import Phrase, SketchCall
from app.programs.sketches.towers import Pair
from app.programs.sketches.verbs import LITERAL, place_of

Signatures = Mapping[str, ActionSignature]
"""The actions on offer, by their names."""


def retold(
    calls: Sequence[SketchCall], pairs: Sequence[Pair], signatures: Signatures
) -> list[SketchCall]:
    """The calls with the pairs for all that puts something; as they are where nothing does."""
    puts = [call for call in calls if _puts(call.action, signatures)]
    if not puts:
        return list(calls)
    action = puts[-1].action
    place = place_of(signatures[action], ())
    told = [
        SketchCall(
            action, tuple(Phrase(text=name) for name in (pair[::-1] if place == 0 else pair))
        )
        for pair in pairs
    ]
    return [*(call for call in calls if call not in puts), *told]


def places_used(calls: Iterable[ActionCall], signatures: Signatures) -> set[str]:
    """The names of what the calls put something in or on."""
    return {
        str(call.arguments[place])
        for call in calls
        if _puts(call.action, signatures)
        and (place := place_of(signatures[call.action], ())) is not None
    }


def _puts(action: str, signatures: Signatures) -> bool:
    signature = signatures.get(action)
    return signature is not None and len(signature.parameters) == 2 and action not in LITERAL
