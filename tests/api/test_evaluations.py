import pytest

from app.llm.backends.scripted import Answer, ScriptedModel
from app.worker.evaluating import Evaluating

REQUEST = {
    "suite": "robot-tasks",
    "planners": [
        {"name": "progprompt", "model": "scripted"},
        {"name": "progprompt", "model": "scripted", "comments": False},
    ],
    "tasks": [
        "put the banana in the bowl, 0 distractors",
        "put the pear on the plate, 1 distractor",
    ],
}


@pytest.fixture
def evaluating(parts):
    model = ScriptedModel([Answer(text="    grab_and_putin('banana', 'bowl')\n")])
    return Evaluating(parts.database, parts.jobs, lambda *_: model)


@pytest.fixture
def place(client):
    answer = client.post("/evaluations", json=REQUEST)
    assert answer.status_code == 202
    assert answer.headers["location"] == f"/evaluations/{answer.json()['id']}"
    return answer.headers["location"]


@pytest.fixture
def finished(place, evaluating):
    for index in range(4):
        evaluating(f"{place.rpartition('/')[2]}:{index}")
    return place


def test_an_evaluation_tells_how_far_it_is(client, place, evaluating):
    shown = client.get(place).json()
    assert (shown["status"], shown["done"], shown["total"]) == ("queued", 0, 4)
    evaluating(f"{shown['id']}:0")
    shown = client.get(place).json()
    assert (shown["status"], shown["done"]) == ("running", 1)
    assert shown["seconds_left"] > 0
    [listed] = client.get("/evaluations").json()["items"]
    assert listed["seconds_left"] > 0
    assert listed | {"seconds_left": None} == shown | {"seconds_left": None}


def test_a_finished_evaluation_has_results_by_parts(client, finished):
    assert client.get(finished).json()["status"] == "succeeded"
    part = client.get(f"{finished}/results", params={"limit": 3}).json()
    rest = client.get(f"{finished}/results", params={"cursor": part["next"]}).json()
    assert [item["index"] for item in part["items"] + rest["items"]] == [0, 1, 2, 3]
    assert [item["plan"]["strict"] for item in part["items"]] == [True, False, True]
    assert rest["next"] is None


@pytest.mark.parametrize(
    ("form", "kind", "words"),
    [
        ("csv", "text/csv", 'methods,"progprompt, comments",strict Plan SR,0.5'),
        ("markdown", "text/markdown", "| progprompt, no comments | 2 |"),
        ("html", "text/html", "<!doctype html>"),
    ],
)
def test_its_tables_come_in_several_forms(client, finished, form, kind, words):
    answer = client.get(f"{finished}/tables", params={"format": form})
    assert answer.headers["content-type"].startswith(kind)
    assert words in answer.text


def test_its_tables_are_json_unless_asked_otherwise(client, finished):
    found = client.get(f"{finished}/tables").json()
    methods = found["tables"][0]
    assert methods["rows"][0][0] == "progprompt, comments"
    strict = methods["rows"][0][methods["columns"].index("strict Plan SR")]
    assert strict["mean"] == 0.5
    assert strict["interval"][0] < 0.5 < strict["interval"][1]


def test_tables_of_a_partial_evaluation_can_be_read(client, place):
    assert client.get(f"{place}/tables").json()["tables"] == []
    assert client.get(f"{place}/tables", params={"format": "html"}).status_code == 200


def test_a_verdict_of_a_person_is_kept_beside_and_counts_for_sr(client, finished, problem_of):
    verdict = {"success": True, "note": "good enough"}
    answer = client.put(f"{finished}/results/1/verdict", json=verdict)
    assert answer.json()["verdict"] == verdict
    assert answer.json()["plan"]["success"] is False
    page = client.get(f"{finished}/tables", params={"format": "html"}).text
    assert "reached: good enough" in page
    problem_of(client.put(f"{finished}/results/9/verdict", json=verdict), 404)


def test_a_cancelled_evaluation_keeps_its_results_and_gets_no_more(
    client, place, evaluating, problem_of
):
    name = place.rpartition("/")[2]
    evaluating(f"{name}:0")
    assert client.post(f"{place}/cancel").json()["status"] == "cancelled"
    assert client.post(f"{place}/cancel").status_code == 202
    evaluating(f"{name}:1")
    assert client.get(place).json()["done"] == 1


def test_a_finished_evaluation_cannot_be_cancelled(client, finished, problem_of):
    problem_of(client.post(f"{finished}/cancel"), 409)


def test_two_evaluations_are_compared_pair_by_pair(client, evaluating, problem_of, finished):
    one = {**REQUEST, "planners": REQUEST["planners"][:1]}
    places = [client.post("/evaluations", json=one).json()["id"] for _ in range(2)]
    for name in places:
        for index in range(2):
            evaluating(f"{name}:{index}")
    found = client.get(f"/evaluations/{places[0]}/comparison", params={"other": places[1]}).json()
    assert (found["pairs"], found["difference"], found["p"]) == (2, 0, 1)
    assert found["verdict"] == "no difference shown"
    answer = client.get(f"{finished}/comparison", params={"other": places[1]})
    problem_of(answer, 409)


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"suite": "nonsense"}, "suite"),
        ({"planners": [{"name": "nobody"}]}, "planner"),
        ({"planners": [{"name": "progprompt", "model": "nothing"}]}, "model"),
        ({"tasks": ["no such task"]}, "tasks"),
        ({"languages": ["klingon"]}, "languages.0"),
        ({"runs": 0}, "runs"),
    ],
)
def test_what_cannot_be_measured_is_refused_by_its_field(client, problem_of, change, field):
    problem = problem_of(client.post("/evaluations", json={**REQUEST, **change}), 422)
    assert problem["errors"][0]["field"] == field


def test_the_suites_are_listed(standing):
    suites = {each["name"]: each for each in standing.get("/evaluations/suites").json()["items"]}
    assert suites["tabletop"]["tasks"] >= 120
    assert "de" in suites["tabletop"]["languages"]
