"""A worker process, put together; it knows nothing of HTTP or of views, and so starts fast."""

from app.domain.planner import PlannerOptions
from app.main.models import llm_config
from app.programs.prompt import write_preamble
from app.settings import Settings
from app.storage.database import Database
from app.storage.handover import Handover
from app.storage.jobs import Jobs, Queue
from app.worker.models import Models
from app.worker.planning import Planning
from app.worker.process import WorkerProcess
from app.worker.simulation import Simulation
from app.worlds import worlds


def create_worker(settings: Settings, queue: Queue, worker_id: str) -> WorkerProcess:
    """A worker for one queue."""
    database = Database(settings.database)
    handover = Handover(Jobs(database))
    if queue == "planning":
        models = Models(llm_config(settings), settings.model)
        desk = Planning(database, handover, models)
        prepare = [_load_worlds, models.load_default, lambda: models.warm_default(_preamble())]
    else:
        desk = Simulation(database, handover)
        prepare = [_load_worlds]
    return WorkerProcess(database, queue, worker_id, desk=desk, prepare=prepare)


def _preamble() -> str:
    """What the prompts of the tabletop begin with, as long as nobody asks for other switches."""
    world = worlds["tabletop"]
    return write_preamble(world.name, world.actions, PlannerOptions())


def _load_worlds() -> str:
    return f"knows {', '.join(worlds)}"
