from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_switching import Switching


@actions.register("plugin")
class PlugIn(Switching):
    """Plug it in."""

    signature = ActionSignature(
        name="plugin",
        parameters=(Parameter(name="obj", affordance="has_plug"),),
        meaning="Plug obj in.",
    )
    needed, verb = "HAS_PLUG", "plug in"
    before, after = "PLUGGED_OUT", "PLUGGED_IN"
    needs_hand = True
