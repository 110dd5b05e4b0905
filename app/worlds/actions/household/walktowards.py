from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_walking import Walking


@actions.register("walktowards")
class WalkTowards(Walking):
    """Go up to it."""

    signature = ActionSignature(
        name="walktowards",
        parameters=(Parameter(name="obj"),),
        meaning="Walk up to obj.",
    )
