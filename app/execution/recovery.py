"""What is done where an assertion is false."""

from collections.abc import Iterator

from app.domain.plan import GroundedAssertion
from app.domain.trace import Happening, RecoveryTaken
from app.domain.world import World
from app.execution.assertion import StateCheck, check
from app.execution.call import perform, skip

MAX_RECOVERY_CALLS = 8
"""Calls made for one assertion; further ones are skipped."""


def demand(assertion: GroundedAssertion, world: World, decider: StateCheck) -> Iterator[Happening]:
    """Decide the assertion and, as long as it is false, make its recovery's calls one by one.

    Before each further call it is decided anew, as the paper does with its chained recoveries.
    """
    checked = check(assertion, world, decider)
    yield checked
    if checked.holds or not assertion.recovery:
        return
    calls = assertion.recovery[:MAX_RECOVERY_CALLS]
    yield RecoveryTaken(line=assertion.line, calls=len(calls), time=world.time)
    for place, call in enumerate(calls):
        if place:
            checked = check(assertion, world, decider)
            yield checked
            if checked.holds:
                return
        yield from perform(call, world)
    for call in assertion.recovery[MAX_RECOVERY_CALLS:]:
        reason = f"one assertion may make {MAX_RECOVERY_CALLS} recovery calls"
        yield skip(call, reason, world)
