from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_nudging import Nudging


@actions.register("push")
class Push(Nudging):
    """Push it a little; it stays where it is as far as anybody can tell."""

    signature = ActionSignature(
        name="push",
        parameters=(Parameter(name="obj", affordance="movable"),),
        meaning="Push obj.",
    )
    verb = "push"
