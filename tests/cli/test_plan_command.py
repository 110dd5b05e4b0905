import json

import pytest
from click.testing import CliRunner

from app.cli.plan import command, following

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
