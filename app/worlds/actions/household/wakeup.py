from app.domain.action import ActionSignature
from app.worlds.actions.household import actions
from app.worlds.actions.household_resting import Resting


@actions.register("wakeup")
class WakeUp(Resting):
    """Wake up where one sits or lies."""

    signature = ActionSignature(
        name="wakeup",
        parameters=(),
        meaning="Wake up.",
    )
