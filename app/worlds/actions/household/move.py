from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_nudging import Nudging


@actions.register("move")
class Move(Nudging):
    """Move it a little; it stays where it is as far as anybody can tell."""

    signature = ActionSignature(
        name="move",
        parameters=(Parameter(name="obj", affordance="movable"),),
        meaning="Move obj.",
    )
    verb = "move"
