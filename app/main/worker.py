"""A worker process, put together; it knows nothing of HTTP or of views, and so starts fast."""

from collections.abc import Iterator, Mapping
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
        expected = _expected(settings)
        model = planners[expected["tabletop"]].model
        prepare = [
            _load_worlds,
            *(partial(_prepare, name) for name in sorted(set(expected.values()))),
            partial(models.load, model),
            *(partial(models.warm, model, each) for each in _preambles(expected, model)),
        ]
    else:
        desk = Simulation(database, handover, models)
        prepare = [_load_worlds]
    return WorkerProcess(database, queue, name, desk=desk, prepare=prepare)


def _expected(settings: Settings) -> dict[str, str]:
    """The planner that most plans will want in each world."""
    if settings.model != "default":
        return dict.fromkeys(worlds, "progprompt")
    return {name: world.planner for name, world in worlds.items()}


def _preambles(expected: Mapping[str, str], model: str) -> Iterator[str]:
    """What the prompts for this model will begin with, world by world."""
    for name, chosen in expected.items():
        planner = planners[chosen]
        if planner.model == model and isinstance(planner, Preambled):
            yield planner.preamble(name, offered(worlds[name], Scene(world=name)))


def _prepare(name: str) -> str:
    planner = planners[name]
    if isinstance(planner, Prepared):
        planner.prepare()
    return f"plans with {name}"


def _load_worlds() -> str:
    return f"knows {', '.join(worlds)}"
