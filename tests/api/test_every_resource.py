"""One look at everything the service offers."""

import re

import pytest

from app.storage import scenes, workers
from app.storage.workers import WorkerRow

CATALOGUES = ("worlds", "objects", "actions", "models", "planners", "robots")


def test_every_operation_is_described_and_answers_problems_with_documents(standing):
    paths = standing.get("/openapi.json").json()["paths"]
    operations = [one for path in paths.values() for one in path.values()]
    assert len(operations) >= 20
    assert all(one.get("description") for one in operations)


def test_every_readable_place_without_an_id_answers(standing):
    for path, operations in standing.get("/openapi.json").json()["paths"].items():
        if "get" in operations and "{" not in path and path != "/readyz":
            assert standing.get(path).status_code == 200, path


def test_every_field_a_client_may_send_is_described(standing):
    schemas = standing.get("/openapi.json").json()["components"]["schemas"]
    for name in ("PlanGiven", "PlannerGiven", "SceneGiven", "ObjectGiven", "ExecutionGiven"):
        for field, schema in schemas[name]["properties"].items():
            assert schema.get("description") or "$ref" in schema, f"{name}.{field}"
        assert schemas[name]["additionalProperties"] is False


def test_the_docs_for_people_are_there(standing):
    assert "ProgPrompt" in standing.get("/docs").text


@pytest.mark.parametrize("name", CATALOGUES)
def test_every_catalogue_lists_what_can_be_named(standing, name):
    items = standing.get(f"/catalog/{name}").json()["items"]
    assert items
    assert all(item["name"] for item in items)


def test_worlds_tell_the_environments_that_a_scene_can_name(standing):
    items = standing.get("/catalog/worlds").json()["items"]
    of = {item["name"]: item["environments"] for item in items}
    assert of["household"][0] == "env0"
    assert of["tabletop"] == []


def test_canned_completions_are_no_model_to_choose_where_there_are_none(standing):
    items = standing.get("/catalog/models").json()["items"]
    assert "scripted" not in [item["name"] for item in items]


def test_a_catalogue_of_an_unknown_world_is_refused(standing, problem_of):
    problem = problem_of(standing.get("/catalog/objects", params={"world": "moon"}), 422)
    assert problem["errors"][0]["field"] == "world"


def test_a_scene_is_kept_changed_and_forgotten(client, problem_of):
    scene = {"world": "tabletop", "objects": [{"name": "cup"}]}
    answer = client.post("/scenes", json=scene)
    assert answer.status_code == 201
    place = answer.headers["location"]
    assert client.get(place).json() == answer.json()
    changed = client.put(place, json={"objects": [{"name": "bowl"}]}).json()
    assert changed["objects"][0]["name"] == "bowl"
    assert client.get(place).json() == changed
    assert client.delete(place).status_code == 204
    problem_of(client.get(place), 404)
    problem_of(client.delete(place), 404)


def test_a_scene_is_checked_and_shown_as_its_world_completes_it(standing):
    scene = {"objects": [{"name": "cup"}, {"name": "bowl"}]}
    first, again, other = (
        standing.post("/scenes/validate", params={"seed": seed}, json=scene).json()
        for seed in (1, 1, 2)
    )
    assert first["valid"]
    assert all(item["position"] for item in first["scene"]["objects"])
    assert first == again != other


@pytest.mark.parametrize("path", ["/scenes", "/scenes/validate"])
def test_a_bad_scene_is_refused_by_fields_that_begin_at_the_scene(standing, problem_of, path):
    scene = {"objects": [{"name": "cup"}, {"name": "cup", "position": [9, 9]}]}
    problem = problem_of(standing.post(path, json=scene), 422)
    fields = {fault["field"] for fault in problem["errors"]}
    assert "objects.1.name" in fields


def test_the_service_is_healthy_before_it_is_ready(client, parts, problem_of):
    assert client.get("/healthz").json() == {"status": "ok"}
    problem = problem_of(client.get("/readyz"), 503)
    assert problem["waiting_for"] == ["a planning worker", "a simulation worker"]
    for queue, ready in (("planning", False), ("simulation", True)):
        with parts.database.transaction() as session:
            row = WorkerRow(id=f"{queue}-1", queue=queue, pid=1, ready=ready, detail="loading")
            workers.report(session, row)
    problem = problem_of(client.get("/readyz"), 503)
    assert problem["waiting_for"] == ["planning-1: loading"]
    with parts.database.transaction() as session:
        row = WorkerRow(id="planning-1", queue="planning", pid=1, ready=True, detail="holds it")
        workers.report(session, row)
    assert client.get("/readyz").status_code == 200


def test_metrics_count_what_went_wrong_inside(client, problem_of, monkeypatch):
    def broken(*args, **values):
        raise ZeroDivisionError

    monkeypatch.setattr(scenes, "page", broken)
    # Its server hangs up after such an answer, which a client that comes back must not meet.
    problem_of(client.get("/scenes", headers={"Connection": "close"}), 500)
    lines = client.get("/metrics").text.splitlines()
    assert 'progprompt_requests_total{method="GET",route="/scenes",status="500"} 1' in lines


def test_metrics_count_requests_and_plans(client, executed):
    lines = client.get("/metrics").text.splitlines()
    assert 'progprompt_plans{status="succeeded"} 1' in lines
    assert 'progprompt_executions{status="succeeded"} 1' in lines
    assert 'progprompt_requests_total{method="POST",route="/plans",status="202"} 1' in lines


def test_the_documentation_needs_no_other_host(client):
    for path in ("/docs", "/redoc"):
        page = client.get(path).text
        fetched = re.findall(r'(?:src|href)="([^"]+)"', page)
        assert fetched
        assert all(address.startswith("/") for address in fetched)
        assert all(client.get(address).status_code == 200 for address in fetched)
