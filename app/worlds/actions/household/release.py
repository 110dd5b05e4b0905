from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_releasing import Releasing


@actions.register("release")
class Release(Releasing):
    """Let go of it where one stands."""

    signature = ActionSignature(
        name="release",
        parameters=(Parameter(name="obj"),),
        meaning="Let go of obj, held in a hand.",
    )
