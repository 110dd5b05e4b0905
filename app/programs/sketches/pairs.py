"""Members of a set and the places they go to → pairs: shared out, dealt out, or piled up."""

import itertools
from collections.abc import Sequence
from dataclasses import replace

from app.domain.errors import TaskDeclined
from app.programs.sketches.sharing import sharing
from app.programs.sketches.sketch import Each, Phrase, Previous, Same, SketchArgument
from app.programs.sketches.things import Thing, listed


def pairs(
    members: list[Thing], spread: SketchArgument | None, targets: Sequence[Thing]
) -> list[tuple[Thing, Thing | None]]:
    match spread:
        case Previous():
            if len(members) < 2:
                raise TaskDeclined(
                    f"a stack takes two things, and there is only {members[0].name}",
                    kind="absent",
                )
            return [(b, a) for a, b in itertools.pairwise(members)]
        case Same():
            return _shared(members, spread, targets)
        case Each():
            return _dealt(members, spread, targets)
        case _:
            return [(member, None) for member in members]


def _shared(
    members: list[Thing], spread: Same, targets: Sequence[Thing]
) -> list[tuple[Thing, Thing | None]]:
    pairs: list[tuple[Thing, Thing | None]] = []
    for member in members:
        shared = sharing(member, targets, spread.property)
        if len(shared) == 1:
            pairs.append((member, shared[0]))
    if not pairs:
        raise TaskDeclined(
            f"none of {listed([t.name for t in targets])} has the same {spread.property} as "
            f"{listed([t.name for t in members], 'or')}",
            kind="absent",
        )
    return pairs


def _dealt(
    members: list[Thing], spread: Each, targets: Sequence[Thing]
) -> list[tuple[Thing, Thing | None]]:
    need = len(targets) * spread.count
    if len(targets) <= len(members) < need:  # "one each": a number that was not meant so
        return list(zip(members, targets, strict=False))
    if len(members) < need:
        raise TaskDeclined(
            f"{need} are needed for {listed([t.name for t in targets])}, and there are only "
            f"{listed([t.name for t in members])}",
            kind="absent",
        )
    return [(members[i], targets[i // spread.count]) for i in range(need)]


def for_each(spread: Each, phrase: Phrase, targets: int) -> tuple[Each, Phrase]:
    """``all('candy', count=1)`` for ``each('cup')`` counts for each of the cups."""
    if targets and phrase.count is not None and phrase.count < targets * spread.count:
        return Each(spread.text, phrase.count), replace(phrase, count=None)
    return spread, phrase
