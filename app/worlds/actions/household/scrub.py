from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_cleaning import Cleaning


@actions.register("scrub")
class Scrub(Cleaning):
    """Scrub it by hand: it is clean then."""

    signature = ActionSignature(
        name="scrub",
        parameters=(Parameter(name="obj"),),
        meaning="Scrub obj.",
    )
