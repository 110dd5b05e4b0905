from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_putting import Putting


@actions.register("putin")
class PutIn(Putting):
    """Let go of it inside something, which has to be open if it can be."""

    signature = ActionSignature(
        name="putin",
        parameters=(
            Parameter(name="obj1", affordance="grabbable"),
            Parameter(name="obj2", role="container"),
        ),
        meaning="Put obj1, held in a hand, into obj2.",
    )
    relation = "INSIDE"
