"""What the household's agent can do, one verb per file."""

from app.registry import Registry
from app.worlds.actions.household_primitive import HouseholdAction

actions: Registry[HouseholdAction] = Registry(__name__, "action")
