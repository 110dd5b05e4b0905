from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_switching import Switching


@actions.register("switchoff")
class SwitchOff(Switching):
    """Let it rest."""

    signature = ActionSignature(
        name="switchoff",
        parameters=(Parameter(name="obj", affordance="has_switch"),),
        meaning="Switch obj off.",
    )
    needed, verb = "HAS_SWITCH", "switch off"
    before, after = "ON", "OFF"
