from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.household import actions
from app.worlds.actions.household_walking import Walking


@actions.register("run")
class Run(Walking):
    """Go there in a hurry."""

    signature = ActionSignature(
        name="run",
        parameters=(Parameter(name="obj"),),
        meaning="Run to obj, an object or a room.",
    )
