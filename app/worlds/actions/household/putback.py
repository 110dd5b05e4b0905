from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_putting import Putting


@actions.register("putback")
class PutBack(Putting):
    """Let go of it on something."""

    signature = ActionSignature(
        name="putback",
        parameters=(
            Parameter(name="obj1", affordance="grabbable"),
            Parameter(name="obj2", role="support"),
        ),
        meaning="Put obj1, held in a hand, onto obj2.",
    )
    relation = "ON"
