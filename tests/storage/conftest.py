"""Rows to hang others on."""

import pytest

from app.storage.base import new_id, now
from app.storage.executions import ExecutionRow
from app.storage.plans import PlanRow

SCENE = {"world": "tabletop", "objects": [], "actions": None, "environment": None}


@pytest.fixture
def make_plan(database):
    def make(**values):
        plan = PlanRow(
            **{
                "id": new_id("pl"),
                "created_at": now(),
                "status": "queued",
                "request_digest": "",
                "instruction": "wave",
                "given_scene": SCENE,
                "scene": SCENE,
                "seed": 0,
                "execute": True,
                "approval": "auto",
                "goal": [],
                "planner": {},
            }
            | values
        )
        with database.transaction() as session:
            session.add(plan)
        return plan

    return make


@pytest.fixture
def execution(database, make_plan):
    row = ExecutionRow(
        id=new_id("ex"),
        plan_id=make_plan().id,
        created_at=now(),
        status="executing",
        seed=0,
        scene=SCENE,
    )
    with database.transaction() as session:
        session.add(row)
    return row
