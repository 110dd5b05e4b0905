from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_releasing import Releasing


@actions.register("drop")
class Drop(Releasing):
    """Let it fall where one stands."""

    signature = ActionSignature(
        name="drop",
        parameters=(Parameter(name="obj"),),
        meaning="Drop obj, held in a hand.",
    )
