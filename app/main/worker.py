"""A worker process, put together; it knows nothing of HTTP or of views, and so starts fast."""

from functools import partial

from app.domain.planner import Preambled, Prepared
from app.domain.scene import Scene
from app.main.models import llm_config, open_models
from app.main.worlds import furnish
from app.planners import planners
from app.rollout import offered
from app.settings import Settings
from app.storage.database import Database
from app.storage.handover import Handover
from app.storage.jobs import Jobs, Queue
from app.worker.evaluating import Evaluating, SharedDesk
from app.worker.planning import Planning
from app.worker.process import WorkerProcess
from app.worker.simulation import Simulation
from app.worlds import worlds


def create_worker(settings: Settings, queue: Queue, name: str) -> WorkerProcess:
    """A worker for one queue, which people know by its name."""
    database = Database(settings.database)
    jobs = Jobs(database)
    handover = Handover(jobs)
    furnish(settings, database)
    models = open_models(llm_config(settings), settings.model)
    if queue == "planning":
        desk = SharedDesk(Planning(database, handover, models), Evaluating(database, jobs, models))
        model, preambles = _expected(settings)
        prepare = [
            _load_worlds,
            *(partial(_prepare, world.planner) for world in worlds.values()),
            partial(models.load, model),
            *(partial(models.warm, model, preamble) for preamble in preambles),
        ]
    else:
        desk = Simulation(database, handover, models)
        prepare = [_load_worlds]
    return WorkerProcess(database, queue, name, desk=desk, prepare=prepare)


def _expected(settings: Settings) -> tuple[str, list[str]]:
    """The model that most plans will want, and what its prompts will begin with in each world."""
    expected = "progprompt" if settings.model != "default" else worlds["tabletop"].planner
    model = planners[expected].model
    preambles: list[str] = []
    for world in worlds.values():
        planner = planners[world.planner if settings.model == "default" else expected]
        if planner.model == model and isinstance(planner, Preambled):
            actions = offered(world, Scene(world=world.name))
            preambles.append(planner.preamble(world.name, actions))
    return model, preambles


def _prepare(name: str) -> str:
    planner = planners[name]
    if isinstance(planner, Prepared):
        planner.prepare()
    return f"plans with {name}"


def _load_worlds() -> str:
    return f"knows {', '.join(worlds)}"
