"""What the tabletop robot can do, one verb per file."""

from app.registry import Registry
from app.worlds.actions.primitive import TabletopAction

actions: Registry[TabletopAction] = Registry(__name__, "action")
