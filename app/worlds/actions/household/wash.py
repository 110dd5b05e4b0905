from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_cleaning import Cleaning


@actions.register("wash")
class Wash(Cleaning):
    """Wash it by hand: it is clean then."""

    signature = ActionSignature(
        name="wash",
        parameters=(Parameter(name="obj"),),
        meaning="Wash obj by hand.",
    )
