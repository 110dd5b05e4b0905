from app.domain.action import ActionSignature, Parameter
from app.worlds.actions.shutting import Shutting
from app.worlds.actions.tabletop import actions


@actions.register("open")
class Open(Shutting):
    """Opens a drawer, a door or a lid by its handle."""

    signature = ActionSignature(
        name="open",
        parameters=(Parameter(name="obj"),),
        meaning="Open obj, which has a drawer, a door or a lid.",
        said=r"\bopen\b",
    )
    wanted, undone = "open", "closed"
