import json
from typing import cast

import httpx
import pytest
from click.testing import CliRunner
from rich.console import Console

from app.cli.client import ServiceClient, problem
from app.cli.plan import carry_out, command, following

NOBODY = "http://127.0.0.1:9"


@pytest.fixture
def run(tmp_path):
    def run(content, *options):
        file = tmp_path / "scene.json"
        file.write_text(content)
        arguments = ["put the banana in the bowl", f"--scene={file}", f"--url={NOBODY}", *options]
        return CliRunner().invoke(command, arguments)

    return run


def test_where_no_service_answers_it_says_how_to_start_one(run):
    result = run(json.dumps({"world": "tabletop", "objects": [{"name": "banana"}]}))
    assert result.exit_code == 1
    assert f"no service answers at {NOBODY}" in result.output
    assert "progprompt serve" in result.output


def test_a_scene_file_that_is_not_json_is_named(run):
    result = run("{world")
    assert result.exit_code == 1
    assert "scene.json is not JSON" in result.output


def test_a_scene_file_that_is_no_object_is_refused(run):
    result = run("[]")
    assert result.exit_code == 1
    assert "should hold a JSON object" in result.output


def test_a_robot_cannot_be_changed_in_the_middle_of_a_dialogue():
    result = CliRunner().invoke(command, ["now the other", "--after=pl_1", "--robot=ur5e"])
    assert result.exit_code == 2
    assert "leave --robot out" in result.output


def test_the_next_sentence_of_a_talk_keeps_what_the_options_asked_for():
    first = {
        "scene": {},
        "instruction": "a",
        "seed": 3,
        "execute": False,
        "planner": {"model": "x"},
    }
    second = following({**first, "goal": ["in(a, b)"]}, "pl_1", "now the other one")
    assert second["parent"] == "pl_1"
    assert second["instruction"] == "now the other one"
    assert (second["seed"], second["execute"], second["planner"]) == (3, False, {"model": "x"})
    assert following(second, "pl_2", "and back")["execute"] is False


def test_a_problem_is_told_once():
    document = {
        "detail": "seed: is no number",
        "errors": [{"field": "seed", "message": "is no number"}],
    }
    assert problem(httpx.Response(422, json=document)) == "seed: is no number"
    document["errors"].append({"field": "goal.0", "message": "is empty"})
    assert problem(httpx.Response(422, json=document)).splitlines() == [
        "seed: is no number",
        "  goal.0: is empty",
    ]


def test_an_interrupt_cancels_the_plan_and_says_so(capsys):
    class Interrupted:
        url, asked = "http://robot", ""

        def create_plan(self, request):
            return {"id": "pl_1", "status": "queued", "instruction": "go", "scene": {}}

        def events(self, path, after=-1):
            raise KeyboardInterrupt

        def cancel(self, path):
            self.asked = path

    client = Interrupted()
    with pytest.raises(SystemExit) as ended:
        carry_out(cast("ServiceClient", client), {}, Console())
    assert ended.value.code == 130
    assert client.asked == "/plans/pl_1"
    told = capsys.readouterr().out
    assert "cancelled" in told
    assert "http://robot/#/plans/pl_1" in told
