from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_walking import Walking


@actions.register("walk")
class Walk(Walking):
    """Go to a room or an object; doors are no obstacle."""

    signature = ActionSignature(
        name="walk",
        parameters=(Parameter(name="obj"),),
        meaning="Walk to obj, an object or a room.",
    )
