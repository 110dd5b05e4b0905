"""The HTTP service, put together."""

from fastapi import FastAPI

from app.api.app import create_app
from app.api.parts import Parts
from app.api.rollouts import StoredRollout
from app.main.models import llm_config
from app.main.worlds import furnish
from app.settings import Settings
from app.storage.database import Database
from app.storage.handover import Handover
from app.storage.jobs import Jobs
from app.view.viewer import Viewer


def create_service(settings: Settings) -> FastAPI:
    """The HTTP service over a migrated database."""
    database = Database(settings.database)
    jobs = Jobs(database)
    parts = Parts(
        database=database,
        handover=Handover(jobs),
        jobs=jobs,
        llm=llm_config(settings),
        default_model=settings.model,
        vision=bool(settings.vision_url),
    )
    furnish(settings, database)
    viewer = Viewer(lambda execution_id: StoredRollout(database, execution_id))
    return create_app(parts, viewer)
