from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.shutting import Shutting
from app.worlds.actions.tabletop import actions


@actions.register("close")
class Close(Shutting):
    """Closes a drawer, a door or a lid by its handle."""

    signature = ActionSignature(
        name="close",
        parameters=(Parameter(name="obj"),),
        meaning="Close obj, which has a drawer, a door or a lid.",
        said=r"\b(?:close|shut)\b",
    )
    wanted, undone = "closed", "open"
