from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_settling import Settling

BERTHS = {"couch": 2, "sofa": 2, "bed": 3, "bathtub": 2, "loveseat": 2}
"""How much may be on it; one where it is not listed."""


@actions.register("lie")
class Lie(Settling):
    """Lie down on it, if there is room."""

    signature = ActionSignature(
        name="lie",
        parameters=(Parameter(name="obj", affordance="lieable"),),
        meaning="Lie down on obj.",
    )
    posture, needed, verb = "LYING", "LIEABLE", "lie on"
    room = BERTHS
