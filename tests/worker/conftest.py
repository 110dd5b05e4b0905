"""Plans to work on, and desks to work at, without any queue in between."""

import pytest

from app.domain.scene import Scene, SceneObject
from app.llm.backends.scripted import Answer, ScriptedModel
from app.storage import executions, plans
from app.storage.base import new_id, now
from app.storage.documents import scene_document
from app.storage.handover import Handover, execution_of
from app.storage.jobs import Jobs
from app.storage.plans import PlanRow
from app.worker.planning import Planning
from app.worker.simulation import Simulation
from app.worlds import worlds

BODY = """\
    # 1: put the banana in the bowl
    grab_and_putin('banana', 'bowl')
    # 2: put the apple in the bowl
    grab_and_putin('apple', 'bowl')
"""
PROGRAM = f"def put_the_fruits_in_the_bowl():\n{BODY}"
GOAL = ["in(banana, bowl)", "in(apple, bowl)"]


@pytest.fixture
def handover(database):
    jobs = Jobs(database)
    jobs.register_queues()
    yield Handover(jobs)
    jobs.close()


@pytest.fixture(scope="session")
def scene():
    objects = tuple(SceneObject(name=name) for name in ("banana", "apple", "bowl"))
    return worlds["tabletop"].complete(Scene(world="perfect", objects=objects), 0)


@pytest.fixture
def make_plan(database, scene):
    def make(**values):
        plan = PlanRow(
            **{
                "id": new_id("pl"),
                "created_at": now(),
                "status": "queued",
                "request_digest": "",
                "instruction": "put the fruits in the bowl",
                "given_scene": scene_document(scene),
                "scene": scene_document(scene),
                "seed": 0,
                "execute": True,
                "approval": "auto",
                "goal": GOAL,
                "planner": {"model": "scripted"},
            }
            | values
        )
        with database.transaction() as session:
            session.add(plan)
        return plan.id

    return make


@pytest.fixture
def make_planning(database, handover):
    def make(*answers):
        model = ScriptedModel(answers or (Answer(text=BODY),))
        return Planning(database, handover, lambda *names: model)

    return make


@pytest.fixture
def make_execution(database, handover, make_plan):
    def make(**values):
        plan_id = make_plan(**{"status": "planned", "program": PROGRAM} | values)
        with database.transaction() as session:
            plan = plans.get(session, plan_id)
            return handover.approved(session, plan, execution_of(session, plan)).id

    return make


@pytest.fixture
def simulation(database, handover):
    return Simulation(database, handover, lambda *names: ScriptedModel([Answer(text="True")]))


@pytest.fixture
def read_plan(database):
    def read(plan_id):
        with database.reading() as session:
            return plans.get(session, plan_id)

    return read


@pytest.fixture
def read_execution(database):
    def read(execution_id):
        with database.reading() as session:
            return executions.get(session, execution_id)

    return read
