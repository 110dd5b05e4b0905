"""What the settings say about worlds."""

from app.settings import Settings
from app.worlds import worlds
from app.worlds.household import Household


def furnish(settings: Settings) -> None:
    """Load the worlds, now rather than at the first request, with the homes of the settings."""
    household = worlds["household"]
    assert isinstance(household, Household)
    household.homes(settings.household_data)
