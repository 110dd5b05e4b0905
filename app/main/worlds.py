"""What the settings and the database say about worlds."""

from app.main.models import vision_endpoint
from app.settings import Settings
from app.storage.assets import lookup
from app.storage.database import Database
from app.worlds import worlds
from app.worlds.household import Household
from app.worlds.tabletop import Tabletop


def furnish(settings: Settings, database: Database) -> None:
    """Load the worlds, now rather than at the first request.

    The household gets the homes of the settings, the tabletop the assets of the database
    and the vision model.
    """
    household = worlds["household"]
    assert isinstance(household, Household)
    household.homes(settings.household_data)
    tabletop = worlds["tabletop"]
    assert isinstance(tabletop, Tabletop)
    tabletop.assets(lookup(database))
    tabletop.look_with(vision_endpoint(settings))
