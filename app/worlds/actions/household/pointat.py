from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_regarding import Regarding


@actions.register("pointat")
class PointAt(Regarding):
    """Point at what is faced."""

    signature = ActionSignature(
        name="pointat",
        parameters=(Parameter(name="obj"),),
        meaning="Point at obj.",
    )
