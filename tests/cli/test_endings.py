"""However a command ends: nothing it started goes on, and what an evaluation found is kept."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

from app.cli.endings import INTERRUPTED, interrupted
from tests.processes import ENDINGS, LIMIT, descendants, runs, within_limit

QUICK = {"text": "    grab_and_putin('banana', 'bowl')\n"}
FIRST = {**QUICK, "when": "put the banana in the bowl"}
STUCK = {**QUICK, "delay": 1000}


@pytest.fixture
def start(tmp_path):
    """Starts an evaluation over two processes whose model gives these answers."""
    started = []
    told = (tmp_path / "told").open("w")

    def start(*answers):
        script = tmp_path / "script.json"
        script.write_text(json.dumps(answers))
        options = ["--model=scripted", "--planner=progprompt", "--limit=4", "--jobs=2"]
        command = [sys.executable, "-m", "app.cli", "eval", "robot-tasks", *options]
        process = subprocess.Popen(
            [*command, f"--out={tmp_path / 'out'}"],
            env=os.environ | {"PROGPROMPT_SCRIPTED": str(script)},
            stdout=told,
            stderr=subprocess.DEVNULL,
        )
        started.append(process)
        return process

    with told:
        yield start
    for process in started:
        process.kill()
        process.wait()


@pytest.mark.parametrize("number", ENDINGS)
def test_an_evaluation_leaves_no_process_behind_and_can_be_gone_on_with(start, tmp_path, number):
    results = tmp_path / "out" / "results.jsonl"
    process = start(FIRST, STUCK)
    within_limit(lambda: results.exists() and results.read_text().count("\n"))
    workers = within_limit(lambda: descendants(process.pid))
    process.send_signal(number)
    code = process.wait(LIMIT)
    within_limit(lambda: not any(map(runs, workers)))
    kept = results.read_text()
    if number != signal.SIGKILL:
        assert code == INTERRUPTED
        assert "run it again to go on" in (tmp_path / "told").read_text()
        assert (tmp_path / "out" / "report.html").exists()
    assert start(QUICK).wait(LIMIT) == 0
    assert results.read_text().startswith(kept)
    assert results.read_text().count("\n") == 4


@pytest.mark.parametrize("words", [("demo", "--port=0", "--model=scripted"), ("bench", "api")])
def test_a_command_that_is_asked_to_end_takes_its_service_with_it(tmp_path, words):
    script = tmp_path / "script.json"
    script.write_text(json.dumps([STUCK]))
    places = {"PROGPROMPT_SCRIPTED": str(script), "XDG_DATA_HOME": str(tmp_path)}
    process = subprocess.Popen(
        [sys.executable, "-m", "app.cli", *words],
        env=os.environ | places,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        started = within_limit(lambda: len(found := descendants(process.pid)) > 1 and found)
        process.terminate()
        process.wait(LIMIT)
        within_limit(lambda: not any(map(runs, started)))
    finally:
        process.kill()
        process.wait()


class Clearing:
    """Is asked to end while it is cleared away."""

    def __del__(self):
        signal.raise_signal(signal.SIGTERM)


def asked_while_clearing():
    Clearing()
    time.sleep(LIMIT)


def test_being_asked_to_end_while_something_is_cleared_away_is_not_lost():
    with interrupted(), pytest.raises(KeyboardInterrupt):
        asked_while_clearing()
