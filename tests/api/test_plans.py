import json
import secrets
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from app.llm.backends.scripted import Answer, ScriptedModel
from app.worker.planning import Planning
from app.worlds import worlds

PROGRAM = "def f():\n    # go\n    grab_and_putin('banana', 'bowl')\n"


def without(body, *fields, **more):
    return {name: value for name, value in body.items() if name not in fields} | more


def test_a_plan_is_accepted_with_its_place_and_everything_filled_in(client, request_body):
    answer = client.post("/plans", json=request_body)
    plan = answer.json()
    assert answer.status_code == 202
    assert answer.headers["location"] == f"/plans/{plan['id']}"
    assert plan["status"] == "queued"
    assert all(item["position"] and item["kind"] for item in plan["scene"]["objects"])
    assert plan["planner"]["examples"] == 3
    assert client.get(answer.headers["location"]).json() == plan


def test_only_scene_and_instruction_are_needed(client):
    answer = client.post(
        "/plans", json={"scene": {"objects": [{"name": "cup"}]}, "instruction": "wave at the cup"}
    )
    plan = answer.json()
    assert answer.status_code == 202
    assert (plan["scene"]["world"], plan["execute"], plan["seed"]) == ("tabletop", True, 0)


def test_the_contracts_own_example_is_taken(client):
    body = json.loads(
        """{"scene": {"world": "tabletop", "objects": [
              {"name": "banana", "kind": "banana", "category": "fruit"},
              {"name": "bowl", "kind": "bowl", "position": [0.5, 0.2]}]},
            "instruction": "put the banana in the bowl",
            "execute": true, "seed": 0, "goal": ["in(banana, bowl)"],
            "planner": {"name": "progprompt", "model": "default", "comments": true,
                        "feedback": true, "examples": 3, "constrained": true, "temperature": 0.0,
                        "max_replans": 2, "state_check": "world"},
            "approval": "auto"}"""
    )
    plan = client.post("/plans", json=body).json()
    assert plan["planner"] == plan["planner"] | body["planner"]
    assert plan["scene"]["objects"][1]["position"] == [0.5, 0.2, 0.0]
    assert plan["replans"] == 0


def test_a_plan_runs_from_the_sentence_to_its_scores(client, executed):
    plan_id, execution_id = executed
    plan = client.get(f"/plans/{plan_id}").json()
    assert (plan["status"], plan["executions"]) == ("succeeded", [execution_id])
    assert plan["plan_scores"]["sr"] == 1
    assert plan["steps"] == [
        {
            "line": 4,
            "action": "grab_and_putin",
            "arguments": ["banana", "bowl"],
            "comment": "1: put the banana in the bowl",
        }
    ]


def test_the_same_key_gives_the_same_plan_however_often(client, request_body):
    headers = {"Idempotency-Key": "a"}
    ids = {client.post("/plans", json=request_body, headers=headers).json()["id"] for _ in "123"}
    assert len(ids) == 1
    assert len(client.get("/plans").json()["items"]) == 1


def test_the_same_key_with_another_request_is_refused(client, request_body, problem_of):
    headers = {"Idempotency-Key": "a"}
    client.post("/plans", json=request_body, headers=headers)
    other = request_body | {"seed": 1}
    problem = problem_of(client.post("/plans", json=other, headers=headers), 422)
    assert problem["errors"][0]["field"] == "Idempotency-Key"


def test_without_a_key_every_request_is_its_own_plan(client, request_body):
    ids = {client.post("/plans", json=request_body).json()["id"] for _ in "12"}
    assert len(ids) == 2


def test_a_program_written_by_hand_needs_no_model(client, request_body, carry_out):
    body = without(request_body, "planner", "instruction", program=PROGRAM)
    plan = client.post("/plans", json=body).json()
    assert (plan["status"], plan["instruction"], plan["planner"]) == ("executing", "f", None)
    assert plan["plan_scores"]["sr"] == 1
    carry_out(plan["executions"][0])
    assert client.get(f"/plans/{plan['id']}").json()["status"] == "succeeded"


def test_a_program_that_is_not_to_be_executed_stays_planned_until_it_is(client, request_body):
    plan = client.post("/plans", json=request_body | {"program": PROGRAM, "execute": False}).json()
    assert (plan["status"], plan["executions"]) == ("planned", [])
    answer = client.post(f"/plans/{plan['id']}/executions")
    assert answer.status_code == 202
    assert answer.headers["location"] == f"/executions/{answer.json()['id']}"
    assert (answer.json()["seed"], answer.json()["what_if"]) == (0, False)
    assert client.get(f"/plans/{plan['id']}").json()["status"] == "executing"


STACKED = PROGRAM.replace("'banana', 'bowl'", "'bowl', 'banana'")


@pytest.mark.parametrize("changed", [{"seed": 3}, {"program": STACKED}, {"after": "the first"}])
def test_a_what_if_leaves_the_plan_as_it_is(client, executed, carry_out, changed):
    plan_id, execution_id = executed
    before = client.get(f"/plans/{plan_id}").json()
    body = {"after": execution_id} if "after" in changed else changed
    what_if = client.post(f"/plans/{plan_id}/executions", json=body).json()
    assert what_if["what_if"]
    assert client.get(f"/plans/{plan_id}").json()["status"] == "succeeded"
    carry_out(what_if["id"])
    after = client.get(f"/plans/{plan_id}").json()
    assert after == before | {"executions": [execution_id, what_if["id"]]}


def test_a_repetition_leaves_the_plan_as_it_is(client, executed):
    plan_id, execution_id = executed
    again = client.post(f"/executions/{execution_id}/rerun").json()["id"]
    client.post(f"/executions/{again}/cancel")
    assert client.get(f"/plans/{plan_id}").json()["status"] == "succeeded"


def test_a_plan_that_follows_begins_where_the_plan_itself_ended(client, executed, carry_out):
    plan_id, execution_id = executed
    for changed in ({"program": STACKED}, {"seed": 3}):
        carry_out(client.post(f"/plans/{plan_id}/executions", json=changed).json()["id"])
    stopped = client.post(f"/plans/{plan_id}/executions").json()["id"]
    client.post(f"/executions/{stopped}/cancel")
    body = {"parent": plan_id, "program": PROGRAM, "goal": ["in(banana, bowl)"]}
    [follower] = client.post("/plans", json=body).json()["executions"]
    assert client.get(f"/executions/{follower}").json()["begins_after"] == execution_id


def test_another_seed_moves_what_was_left_open_and_nothing_else(client, request_body):
    scene = {
        "world": "perfect",
        "objects": [{"name": "banana"}, {"name": "bowl", "position": [0.5, 0.2]}],
    }
    body = request_body | {"scene": scene, "program": PROGRAM, "execute": False}
    plan = client.post("/plans", json=body).json()
    execution = client.post(f"/plans/{plan['id']}/executions", json={"seed": 9}).json()
    same = client.post(f"/plans/{plan['id']}/executions").json()
    banana, bowl = execution["scene"]["objects"]
    assert banana["position"] != plan["scene"]["objects"][0]["position"]
    assert bowl["position"] == [0.5, 0.2, 0.0]
    assert same["scene"] == plan["scene"]


def test_a_plan_waits_for_approval_and_then_runs(client, request_body, plan_it, problem_of):
    plan_id = client.post("/plans", json=request_body | {"approval": "manual"}).json()["id"]
    problem_of(client.post(f"/plans/{plan_id}/approve"), 409)
    plan_it(plan_id)
    assert client.get(f"/plans/{plan_id}").json()["status"] == "awaiting_approval"
    problem_of(client.post(f"/plans/{plan_id}/executions"), 409)
    answer = client.post(f"/plans/{plan_id}/approve")
    assert (answer.status_code, answer.json()["status"]) == (202, "executing")
    assert len(answer.json()["executions"]) == 1


def test_a_queued_plan_is_cancelled_at_once(client, request_body, plan_it):
    plan_id = client.post("/plans", json=request_body).json()["id"]
    assert client.post(f"/plans/{plan_id}/cancel").json()["status"] == "cancelled"
    plan_it(plan_id)
    assert client.get(f"/plans/{plan_id}").json()["status"] == "cancelled"
    assert client.post(f"/plans/{plan_id}/cancel").status_code == 202


def test_a_plan_is_cancelled_at_once_while_its_model_is_loaded(client, request_body, parts):
    loading, loaded = threading.Event(), threading.Event()

    def load(*names):
        loading.set()
        assert loaded.wait(60)
        return ScriptedModel([Answer(text="    grab_and_putin('banana', 'bowl')\n")])

    plan_id = client.post("/plans", json=request_body).json()["id"]
    with ThreadPoolExecutor(1) as worker:
        planning = worker.submit(Planning(parts.database, parts.handover, load), plan_id)
        assert loading.wait(60)
        answer = client.post(f"/plans/{plan_id}/cancel").json()
        followed = client.get(f"/plans/{plan_id}/events").text
        loaded.set()
        planning.result()
    assert answer["status"] == "cancelled"
    assert '"status": "cancelled"' in followed
    assert client.get(f"/plans/{plan_id}").json() == answer
    assert client.get(f"/plans/{plan_id}/events").text == followed


def test_a_plan_that_is_over_cannot_be_cancelled(client, executed, problem_of):
    problem_of(client.post(f"/plans/{executed[0]}/cancel"), 409)


def test_cancelling_a_plan_cancels_its_execution(client, request_body, plan_it, carry_out):
    plan_id = client.post("/plans", json=request_body).json()["id"]
    plan_it(plan_id)
    plan = client.post(f"/plans/{plan_id}/cancel").json()
    carry_out(plan["executions"][0])
    assert client.get(f"/plans/{plan_id}").json()["status"] == "cancelled"
    assert client.get(f"/executions/{plan['executions'][0]}").json()["status"] == "cancelled"


def test_a_stored_scene_can_be_planned_in(client, request_body):
    scene_id = client.post("/scenes", json=request_body["scene"]).json()["id"]
    plan = client.post("/plans", json=without(request_body, "scene", scene_id=scene_id)).json()
    assert plan["scene_id"] == scene_id
    assert [item["name"] for item in plan["scene"]["objects"]] == ["banana", "bowl"]


def test_a_scene_sent_again_is_not_completed_again(client, request_body, monkeypatch):
    completed = []
    complete = worlds["perfect"].complete

    def counting(scene, seed):
        completed.append(seed)
        return complete(scene, seed)

    monkeypatch.setattr(worlds["perfect"], "complete", counting)
    seed = secrets.randbits(31)  # Nobody has asked for it before.
    for each in (seed, seed, seed + 1):
        client.post("/plans", json=request_body | {"seed": each})
    assert completed == [seed, seed + 1]


def test_a_scene_may_name_its_robot_and_else_has_the_usual_one(client, request_body, problem_of):
    def posted(**robot):
        scene = request_body["scene"] | {"world": "tabletop"} | robot
        return client.post("/plans", json=request_body | {"scene": scene})

    assert posted().json()["scene"]["robot"] == "panda"
    assert posted(robot="ur5e").json()["scene"]["robot"] == "ur5e"
    problem = problem_of(posted(robot="c3po"), 422)
    assert problem["errors"][0]["field"] == "scene.robot"
    assert "panda, ur5e" in problem["errors"][0]["message"]


def test_plans_can_be_listed_by_status(client, request_body, executed):
    queued = client.post("/plans", json=request_body).json()["id"]
    listed = client.get("/plans", params={"status": "queued"}).json()["items"]
    assert [plan["id"] for plan in listed] == [queued]


@pytest.mark.parametrize("path", ["/plans", "/scenes", "/executions"])
def test_lists_come_in_parts_newest_first(client, request_body, path):
    made = []
    for _ in range(5):
        plan = client.post("/plans", json=request_body | {"program": PROGRAM}).json()
        scene = client.post("/scenes", json=request_body["scene"]).json()
        ids = {"/plans": plan["id"], "/scenes": scene["id"], "/executions": plan["executions"][0]}
        made.append(ids[path])
    seen, cursor = [], None
    while True:
        page = client.get(path, params={"limit": 2} | ({"cursor": cursor} if cursor else {}))
        seen += [item["id"] for item in page.json()["items"]]
        cursor = page.json()["next"]
        if cursor is None:
            break
    assert seen == made[::-1]


def test_a_vision_model_that_is_not_there_cannot_be_the_detector(client, request_body, problem_of):
    asked = request_body | {"perception": {"detector": "vision"}}
    problem = problem_of(client.post("/plans", json=asked), 422)
    assert problem["errors"][0]["field"] == "perception.detector"
    assert "PROGPROMPT_VISION_URL" in problem["errors"][0]["message"]
    asked = request_body | {"perception": {"detector": "vision", "source": "privileged"}}
    problem = problem_of(client.post("/plans", json=asked), 422)
    assert "only cameras have one" in problem["errors"][0]["message"]
