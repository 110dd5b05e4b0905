"""The database, made ready before anything else starts."""

from app.settings import Settings
from app.storage import workers
from app.storage.database import Database
from app.storage.jobs import QUEUES, Jobs


def migrate(settings: Settings) -> None:
    """Make the data directory and bring the database up to date."""
    settings.data.mkdir(parents=True, exist_ok=True)
    database = Database(settings.database)
    database.migrate()
    jobs = Jobs(database)
    jobs.register_queues()
    jobs.close()
    database.close()


def waits_for(settings: Settings) -> list[str]:
    """What the service waits for before a plan can be made; nothing once it is ready."""
    database = Database(settings.database)
    with database.reading() as session:
        found = workers.waits_for(session, QUEUES)
    database.close()
    return found
