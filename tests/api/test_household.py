"""A home over HTTP: a ready-made one, one of the client's own, and what is wrong with others."""

import pytest

from app.api.rollouts import StoredRollout
from app.view.source import model_of

PROGRAM = """def bring_the_juice_to_the_nightstand():
    find('fridge')
    open('fridge')
    find('juice')
    grab('juice')
    find('nightstand')
    putback('juice', 'nightstand')
"""
OWN = {
    "nodes": [
        {"id": 1, "class_name": "kitchen", "category": "Rooms"},
        {"id": 2, "class_name": "character"},
        {"id": 3, "class_name": "lamp", "properties": ["HAS_SWITCH"], "states": ["OFF"]},
    ],
    "edges": [
        {"from_id": 2, "relation_type": "INSIDE", "to_id": 1},
        {"from_id": 3, "relation_type": "INSIDE", "to_id": 1},
    ],
}


@pytest.fixture
def carried_out(client, carry_out):
    def run(**request):
        answer = client.post("/plans", json=request)
        assert answer.status_code == 202, answer.text
        [execution_id] = answer.json()["executions"]
        carry_out(execution_id)
        return client.get(f"/executions/{execution_id}").json()

    return run


def test_a_program_runs_in_a_ready_made_home_and_is_to_be_seen(carried_out, parts):
    scene = {"world": "household", "environment": "env0"}
    done = carried_out(scene=scene, program=PROGRAM, goal=["on(juice, nightstand)"])
    assert (done["status"], done["error"]) == ("succeeded", None)
    assert done["scores"]["sr"] == 1
    rollout = StoredRollout(parts.database, done["id"])
    frames = rollout.frames(0)
    assert len(frames) > 20
    assert frames.shape[1] == 1 + model_of(rollout).nq


def test_a_home_of_ones_own_is_taken_as_virtualhome_writes_it(carried_out):
    program = "def f():\n    find('lamp')\n    switchon('lamp')\n"
    scene = {"world": "household", "graph": OWN}
    done = carried_out(scene=scene, program=program, goal=["switched_on(lamp)"])
    assert done["status"] == "succeeded"


def test_a_completed_home_lists_its_things(standing):
    body = {"world": "household", "environment": "env1"}
    scene = standing.post("/scenes/validate", json=body).json()["scene"]
    assert scene["environment"] == "env1"
    names = [item["name"] for item in scene["objects"]]
    assert {"fridge", "kitchen"} <= set(names)
    assert "character" not in names


@pytest.mark.parametrize(
    ("scene", "field"),
    [
        ({"environment": "moon"}, "environment"),
        ({"environment": "env0", "graph": OWN}, "environment"),
        ({"objects": [{"name": "unicorn"}]}, "objects.0.name"),
        ({"graph": {"nodes": OWN["nodes"][:1], "edges": []}}, "graph.nodes"),
        ({"graph": {**OWN, "edges": [OWN["edges"][1]]}}, "graph.edges"),
    ],
)
def test_a_home_that_is_none_is_refused_by_its_field(scene, field, standing, problem_of):
    answer = standing.post("/scenes/validate", json={"world": "household", **scene})
    problem = problem_of(answer, 422)
    assert [fault["field"] for fault in problem["errors"]] == [field]
