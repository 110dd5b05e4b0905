from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_cleaning import Cleaning


@actions.register("rinse")
class Rinse(Cleaning):
    """Rinse it by hand: it is clean then."""

    signature = ActionSignature(
        name="rinse",
        parameters=(Parameter(name="obj"),),
        meaning="Rinse obj.",
    )
