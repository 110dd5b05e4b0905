from app.domain.action import ActionSignature
from app.worlds.actions.household import actions
from app.worlds.actions.household_resting import Resting


@actions.register("sleep")
class Sleep(Resting):
    """Sleep where one sits or lies."""

    signature = ActionSignature(
        name="sleep",
        parameters=(),
        meaning="Sleep, sitting or lying.",
    )
