import json
from html.parser import HTMLParser

import pytest
from click.testing import CliRunner

from app.cli import main

BANANA = [{"text": "    grab_and_putin('banana', 'bowl')\n"}]


@pytest.fixture
def run(monkeypatch, tmp_path):
    script = tmp_path / "script.json"
    script.write_text(json.dumps(BANANA))
    monkeypatch.setenv("PROGPROMPT_SCRIPTED", str(script))

    def run(*arguments, code=0):
        answer = CliRunner().invoke(main, ["eval", *map(str, arguments)])
        assert answer.exit_code == code, answer.output
        return answer.output

    return run


@pytest.fixture
def measured(run, tmp_path):
    out = tmp_path / "out"
    told = run(
        *("robot-tasks", "--model", "scripted", "--planner", "progprompt"),
        *("--limit", 4, "--out", out),
    )
    return out, told


def test_the_suites_are_sub_commands(run):
    assert "tabletop" in run("--help")
    assert "--runs" in run("tabletop", "--help")
    assert "No such command" in run("nonsense", code=2)


def test_a_suite_is_measured_and_all_files_are_written(measured):
    out, told = measured
    assert "| progprompt | 4 |" in told
    document = json.loads((out / "results.json").read_text())
    assert len(document["results"]) == 4
    assert document["tables"][0]["columns"][0] == "method"
    assert "strict Plan SR" in (out / "tables.csv").read_text()
    assert (out / "tables.md").read_text().startswith("# Evaluation on robot-tasks")


class Links(HTMLParser):
    def __init__(self):
        super().__init__()
        self.ids, self.targets, self.foreign = set(), set(), []

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.ids.add(given.get("id"))
        for name in ("href", "src"):
            target = given.get(name)
            if target is not None and target.startswith("#"):
                self.targets.add(target[1:])
            elif name in given:
                self.foreign.append(target)


def test_the_report_needs_nothing_else_and_every_link_in_it_leads_somewhere(measured):
    page = (measured[0] / "report.html").read_text()
    links = Links()
    links.feed(page)
    assert links.foreign == []
    assert links.targets <= links.ids
    assert "http" not in page.replace("http-equiv", "")
    assert page.count("<details id=") == 4


def test_a_rerun_goes_on_and_a_verdict_counts(run, measured):
    out, _ = measured
    before = (out / "results.jsonl").read_text()
    key = json.loads(before.splitlines()[-1])["key"]
    run("verdict", out, key, "--success", "--note", "seen it")
    run(
        *("robot-tasks", "--model", "scripted", "--planner", "progprompt"),
        *("--limit", 4, "--out", out),
    )
    assert (out / "results.jsonl").read_text().startswith(before)
    assert "reached: seen it" in (out / "report.html").read_text()
    assert "there is no result" in run("verdict", out, "nothing", "--failure", code=1)


def test_two_folders_are_compared(run, measured):
    assert "4 pairs" in run("compare", measured[0], measured[0])


def test_a_suite_in_a_file_is_linted_and_measured(run, tmp_path):
    task = {
        "name": "banana",
        "category": "own",
        "objects": ["banana", "bowl"],
        "instruction": "put the banana in the bowl",
        "goal": ["in(banana, bowl)"],
    }
    file = tmp_path / "own.jsonl"
    file.write_text(json.dumps(task) + "\n")
    assert "1 tasks, 0 findings" in run("lint", file)
    told = run(file, "--model", "scripted", "--planner", "progprompt", "--out", tmp_path / "own")
    assert "| progprompt | 1 |" in told
    file.write_text(json.dumps({**task, "goal": ["not in(banana, bowl)"]}) + "\n")
    assert "already true" in run("lint", file, code=1)


def test_a_choice_that_leaves_no_task_is_refused(run, tmp_path):
    told = run("tabletop", "--task", "nonsense", "--out", tmp_path / "none", code=1)
    assert "no task is left" in told
    assert "the categories are" in told


def test_an_unknown_planner_is_refused_with_the_names_of_those_there_are(run, tmp_path):
    told = run("tabletop", "--planner", "nobody", "--out", tmp_path / "none", code=1)
    assert "progprompt" in told
