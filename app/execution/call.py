"""One call of a plan, carried out in a world."""

from collections.abc import Iterator
from typing import assert_never

from app.domain.errors import ActionFailure
from app.domain.plan import Call, GroundedCall, RejectedCall
from app.domain.program import ActionCall
from app.domain.trace import (
    ActionFailed,
    ActionPerformed,
    ActionStarted,
    CallSkipped,
    Happening,
    StageReached,
    Tick,
)
from app.domain.world import World


def perform(call: Call, world: World) -> Iterator[Happening]:
    """Carry out the call; a failure is an event like any other, and the plan goes on."""
    match call:
        case RejectedCall():
            yield skip(call, call.reason, world)
        case GroundedCall():
            yield from _act(call, world)
        case _:
            assert_never(call)


def skip(call: Call, reason: str, world: World) -> CallSkipped:
    """The event of a call whose turn came and that was not made."""
    return CallSkipped(line=call.line, text=text_of(call), reason=reason, time=world.time)


def text_of(call: Call) -> str:
    """The call as the program has it."""
    match call:
        case RejectedCall(text=text):
            return text
        case GroundedCall(action=action, arguments=arguments):
            return str(ActionCall(action=action, arguments=arguments))
        case _:
            assert_never(call)


def _act(call: GroundedCall, world: World) -> Iterator[Happening]:
    yield ActionStarted(
        line=call.line, action=call.action, arguments=call.arguments, time=world.time
    )
    reached: tuple[str, int] | None = None
    try:
        for stage in world.perform(call.action, call.arguments):
            if (stage.name, stage.attempt) == reached:
                yield Tick()
                continue
            reached = (stage.name, stage.attempt)
            yield StageReached(
                line=call.line, stage=stage.name, attempt=stage.attempt, time=world.time
            )
    except ActionFailure as failure:
        yield ActionFailed(
            line=call.line,
            stage=failure.stage,
            reason=failure.reason,
            pose=failure.pose,
            time=world.time,
        )
        return
    attempts = reached[1] if reached else 1
    yield ActionPerformed(line=call.line, attempts=attempts, time=world.time)
