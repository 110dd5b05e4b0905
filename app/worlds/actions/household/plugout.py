from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_switching import Switching


@actions.register("plugout")
class PlugOut(Switching):
    """Plug it out."""

    signature = ActionSignature(
        name="plugout",
        parameters=(Parameter(name="obj", affordance="has_plug"),),
        meaning="Plug obj out.",
    )
    needed, verb = "HAS_PLUG", "plug out"
    before, after = "PLUGGED_IN", "PLUGGED_OUT"
    needs_hand = True
