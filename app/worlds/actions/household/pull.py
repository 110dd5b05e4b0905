from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_nudging import Nudging


@actions.register("pull")
class Pull(Nudging):
    """Pull it a little; it stays where it is as far as anybody can tell."""

    signature = ActionSignature(
        name="pull",
        parameters=(Parameter(name="obj", affordance="movable"),),
        meaning="Pull obj.",
    )
    verb = "pull"
