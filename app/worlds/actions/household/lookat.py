from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_regarding import Regarding


@actions.register("lookat")
class LookAt(Regarding):
    """Look at what is faced."""

    signature = ActionSignature(
        name="lookat",
        parameters=(Parameter(name="obj"),),
        meaning="Look at obj.",
    )
