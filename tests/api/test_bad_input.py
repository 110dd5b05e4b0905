"""Whatever a stranger sends ends as a problem document that names the field; nothing breaks."""

import json

import pytest

HUGE = 2_000_000


def posting(client, body):
    return client.post("/plans", json=body)


def scene(*objects, **more):
    return {"scene": {"world": "perfect", "objects": list(objects)} | more}


SCENES = {
    "unknown world": ({"scene": {"world": "moon", "objects": []}}, "scene.world"),
    "duplicate names": (scene({"name": "cup"}, {"name": "cup"}), "scene.objects.1.name"),
    "out of reach": (scene({"name": "cup", "position": [9, 9]}), "scene.objects.0.position"),
    "overlapping": (
        scene(*({"name": name, "position": [0.5, 0.0]} for name in ("cup", "bowl"))),
        "scene.objects.1.position",
    ),
    "empty name": (scene({"name": ""}), "scene.objects.0.name"),
    "name of control characters": (scene({"name": "a\u0000b"}), "scene.objects.0.name"),
    "no name": (scene({"kind": "cup"}), "scene.objects.0.name"),
    "unknown kind": (scene({"name": "cup", "kind": "dragon"}), "scene.objects.0.kind"),
    "unknown field": (scene({"name": "cup", "weight": 3}), "scene.objects.0.weight"),
    "unknown colour": (scene({"name": "cup", "colour": "loud"}), "scene.objects.0.colour"),
    "unknown action": (scene({"name": "cup"}, actions=["fly"]), "scene.actions.0"),
    "5,000 objects": (scene(*({"name": f"cup {n}"} for n in range(5000))), "scene.objects"),
    "overfull": (scene(*({"name": f"cup {n}"} for n in range(200))), "scene.objects"),
    "objects no list": ({"scene": {"objects": "cup"}}, "scene.objects"),
    "scene no object": ({"scene": 7}, "scene"),
    "no scene": ({"scene": None}, "scene"),
    "both scenes": (scene({"name": "cup"}) | {"scene_id": "sc_1"}, "scene"),
    "unknown scene id": ({"scene": None, "scene_id": "sc_none"}, "scene_id"),
}
OTHERS = {
    "empty instruction": ({"instruction": "  "}, "instruction"),
    "no instruction": ({"instruction": None}, "instruction"),
    "huge instruction": ({"instruction": "put " * 5000}, "instruction"),
    "instruction of no letters": ({"instruction": "12 34 !?"}, "instruction"),
    "instruction of control characters": ({"instruction": "put \u0007 it"}, "instruction"),
    "instruction no text": ({"instruction": ["put"]}, "instruction"),
    "malformed goal": ({"goal": ["in(banana"]}, "goal.0"),
    "goal of unknown object": ({"goal": ["in(banana, bowl)", "in(cat, bowl)"]}, "goal.1"),
    "goal of unknown relation": ({"goal": ["eats(banana, bowl)"]}, "goal.0"),
    "deep goal": ({"goal": ["not " * 200 + "in(banana, bowl)"]}, "goal.0"),
    "goal no list": ({"goal": "in(banana, bowl)"}, "goal"),
    "unknown planner": ({"planner": {"name": "tarot"}}, "planner.name"),
    "unknown model": ({"planner": {"model": "gpt-99"}}, "planner.model"),
    "too many examples": ({"planner": {"examples": 8}}, "planner.examples"),
    "too many replans": ({"planner": {"max_replans": 6}}, "planner.max_replans"),
    "unknown planner switch": ({"planner": {"magic": True}}, "planner.magic"),
    "negative seed": ({"seed": -1}, "seed"),
    "huge seed": ({"seed": 10**30}, "seed"),
    "unknown approval": ({"approval": "maybe"}, "approval"),
    "unknown field": ({"speed": 9}, "speed"),
    "program that imports": ({"program": "import os\ndef f():\n    pass\n"}, "program.line 1"),
    "program that calls builtins": (
        {"program": "def f():\n    open('/etc/passwd')\n"},
        "program.line 2",
    ),
    "program of unknown object": (
        {"program": "def f():\n    grab_and_putin('cat', 'bowl')\n"},
        "program.line 2",
    ),
    "program that loops": ({"program": "def f():\n    while True:\n        pass\n"}, "program"),
    "program that does not parse": ({"program": "def f(:\n"}, "program"),
    "program nested 200 deep": ({"program": f"def f():\n    x({'(' * 200}{')' * 200})"}, "program"),
    "empty program": ({"program": ""}, "program"),
}


@pytest.mark.parametrize("name", [*SCENES, *OTHERS])
def test_a_bad_request_is_refused_by_the_name_of_its_field(
    standing, request_body, problem_of, name
):
    change, field = SCENES[name] if name in SCENES else OTHERS[name]
    problem = problem_of(posting(standing, request_body | change), 422)
    assert any(fault["field"].startswith(field) for fault in problem["errors"]), problem
    assert all(fault["message"] for fault in problem["errors"])
    assert standing.get("/plans").json()["items"] == []


def test_all_faults_are_told_at_once(standing, request_body, problem_of):
    body = request_body | {"planner": {"name": "tarot", "model": "gpt-99"}, "instruction": ""}
    problem = problem_of(posting(standing, body), 422)
    fields = {fault["field"] for fault in problem["errors"]}
    assert fields == {"instruction", "planner.name", "planner.model"}


def test_the_other_of_two_names_is_told_as_people_count(standing, problem_of):
    body = {"world": "tabletop", "objects": [{"name": "cup"}, {"name": "cup"}]}
    [fault] = problem_of(standing.post("/scenes/validate", json=body), 422)["errors"]
    assert "object 1 of the list" in fault["message"]


@pytest.mark.parametrize(
    "wrong", [{"kind": "dragon", "colour": "loud"}, {"weight": 3, "height": 3}]
)
def test_of_very_many_faults_it_is_said_how_many_are_left_out(
    standing, problem_of, request_body, wrong
):
    cups = [{"name": f"cup {n}"} | wrong for n in range(40)]
    problem = problem_of(posting(standing, request_body | scene(*cups)), 422)
    assert (len(problem["errors"]), problem["errors_left_out"]) == (50, 30)
    assert problem["detail"].endswith("; and 77 more")
    assert "cup 39" not in problem["detail"]
    assert "errors_left_out" not in problem_of(posting(standing, {}), 422)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "nonsense",
        '{"seed": 1' + "0" * 5000 + "}",
        "[" * 100_000,
        '{"a":' * 50_000 + "1" + "}" * 50_000,
    ],
    ids=["empty", "half", "nonsense", "long number", "deep list", "deep object"],
)
def test_a_body_that_is_no_json_is_refused(standing, problem_of, text):
    answer = standing.post("/plans", content=text, headers={"Content-Type": "application/json"})
    assert answer.status_code in (400, 422)
    problem_of(answer, answer.status_code)


def test_a_body_that_is_no_text_is_refused(standing, problem_of):
    content = {"Content-Type": "application/json"}
    problem_of(standing.post("/plans", content=b"\xff\xfe\x00{", headers=content), 400)


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999"])
def test_numbers_that_are_none_are_refused(standing, request_body, problem_of, number):
    body = json.dumps(request_body | scene({"name": "banana", "position": [0.5, "N"]}))
    body = body.replace('"N"', number)
    answer = standing.post("/plans", content=body, headers={"Content-Type": "application/json"})
    assert problem_of(answer, 422)["errors"][0]["field"] == "scene.objects.0.position.1"


@pytest.mark.parametrize("place", ["instruction", "name", "key"])
def test_lone_surrogates_are_refused(standing, request_body, problem_of, place):
    body = {
        "instruction": request_body | {"instruction": "put \ud800 it"},
        "name": request_body | scene({"name": "cup \udfff"}),
        "key": request_body | {"\ud800": 1},
    }[place]
    content = json.dumps(body)
    answer = standing.post("/plans", content=content, headers={"Content-Type": "application/json"})
    problem_of(answer, 422)


def test_a_body_sent_as_a_form_is_told_to_be_json(standing, problem_of):
    problem_of(standing.post("/plans", data={"instruction": "put"}), 415)


@pytest.mark.parametrize("declared", [True, False])
def test_a_huge_body_is_refused(standing, problem_of, declared):
    body = b" " * HUGE
    content = body if declared else iter([body[: HUGE // 2], body[HUGE // 2 :]])
    answer = standing.post("/plans", content=content, headers={"Content-Type": "application/json"})
    problem_of(answer, 413)


@pytest.mark.parametrize(
    "path",
    [
        "/plans/none",
        "/plans/%00",
        "/plans/none/events",
        "/executions/none",
        "/executions/none/trace",
        "/executions/none/events",
        "/executions/none/frames",
        "/executions/none/recording",
        "/scenes/none",
        "/nowhere",
    ],
)
def test_what_is_not_there_is_not_found(standing, problem_of, path):
    problem_of(standing.get(path), 404)


@pytest.mark.parametrize(
    "path", ["/plans/none/cancel", "/plans/none/approve", "/plans/none/executions"]
)
def test_nothing_can_be_done_with_what_is_not_there(standing, problem_of, path):
    problem_of(standing.post(path), 404)


@pytest.mark.parametrize(
    "query",
    [
        "limit=0",
        "limit=101",
        "limit=x",
        "cursor=abc",
        "cursor=-1",
        "cursor=2147483648",
        "status=asleep",
    ],
)
def test_a_bad_query_is_refused_by_the_name_of_its_field(standing, problem_of, query):
    problem = problem_of(standing.get(f"/plans?{query}"), 422)
    assert problem["errors"][0]["field"] == query.split("=")[0]


def test_a_method_that_is_not_for_this_place_is_refused(standing, problem_of):
    problem_of(standing.delete("/plans"), 405)


def test_a_good_request_is_taken_after_a_bad_one(standing, request_body):
    assert posting(standing, request_body | {"seed": -1}).status_code == 422
    assert posting(standing, request_body).status_code == 202


def test_an_unknown_field_is_told_which_are_known(client):
    for body, known in (
        (scene({"name": "cup", "weight": 3}), "known are name, kind"),
        ({**scene({"name": "cup"}), "planner": {"foo": 1}}, "max_replans"),
        ({**scene({"name": "cup"}), "colour": 1}, "instruction"),
    ):
        (fault,) = [
            e for e in posting(client, body).json()["errors"] if "not known" in e["message"]
        ]
        assert known in fault["message"]
