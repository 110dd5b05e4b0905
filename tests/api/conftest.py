"""The service on a port of its own in this process; its workers' desks are called by hand."""

import socket
import threading
from contextlib import contextmanager

import httpx
import pytest
import uvicorn

from app.api.app import create_app
from app.api.parts import Parts
from app.llm.backends.scripted import Answer, ScriptedModel
from app.llm.models import LlmConfig
from app.storage.database import Database
from app.storage.handover import Handover
from app.storage.jobs import Jobs
from app.worker.planning import Planning
from app.worker.simulation import Simulation
from tests.engines import ENGINES

BODY = "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n"
SCENE = {"world": "perfect", "objects": [{"name": "banana"}, {"name": "bowl"}]}
REQUEST = {
    "scene": SCENE,
    "instruction": "put the banana in the bowl",
    "goal": ["in(banana, bowl)"],
    "planner": {"model": "scripted"},
}
PROGRAM = f"def put_the_banana_in_the_bowl():\n{BODY}"


def parts_over(database):
    jobs = Jobs(database)
    jobs.register_queues()
    return Parts(
        database=database,
        jobs=jobs,
        handover=Handover(jobs),
        llm=LlmConfig(),
        default_model="scripted",
    )


@contextmanager
def serving(parts):
    config = uvicorn.Config(create_app(parts), log_level="error", timeout_graceful_shutdown=1)
    server = uvicorn.Server(config)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        thread = threading.Thread(target=server.run, args=([listener],))
        thread.start()
        url = f"http://127.0.0.1:{listener.getsockname()[1]}"
        with httpx.Client(base_url=url, timeout=60) as client:
            yield client
        server.should_exit = True
        thread.join()


@pytest.fixture
def parts(database):
    return parts_over(database)


@pytest.fixture
def client(parts):
    with serving(parts) as client:
        yield client


@pytest.fixture(scope="session", params=ENGINES)
def standing(request):
    """A service that many tests share: for requests that leave nothing behind."""
    engine = request.getfixturevalue(request.param)
    with engine.migrated() as url, serving(parts_over(Database(url))) as client:
        yield client


@pytest.fixture
def plan_it(parts):
    """What the planning worker does with a plan."""
    return Planning(
        parts.database, parts.handover, lambda *names: ScriptedModel([Answer(text=BODY)])
    )


@pytest.fixture
def carry_out(parts):
    """What the simulation worker does with an execution."""
    return Simulation(
        parts.database, parts.handover, lambda *names: ScriptedModel([Answer(text="True")])
    )


@pytest.fixture
def request_body():
    return REQUEST


@pytest.fixture
def executed(client, plan_it, carry_out):
    """A plan carried out to its end: its id and its execution's."""
    plan_id = client.post("/plans", json=REQUEST).json()["id"]
    plan_it(plan_id)
    [execution_id] = client.get(f"/plans/{plan_id}").json()["executions"]
    carry_out(execution_id)
    return plan_id, execution_id


@pytest.fixture
def problem_of():
    """The problem document of an answer, checked for its form."""

    def read(answer, status):
        assert answer.status_code == status, answer.text
        assert answer.headers["content-type"] == "application/problem+json"
        document = answer.json()
        assert document["status"] == status
        assert document["type"]
        assert document["title"]
        assert document["detail"]
        return document

    return read
