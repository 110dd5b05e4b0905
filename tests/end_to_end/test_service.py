"""One service, from the sentence to the scores, through deaths and restarts."""

import signal
import subprocess
import sys

import pytest

from tests.processes import ENDINGS, runs, within_limit

pytestmark = pytest.mark.physics

REQUEST = {
    "scene": {
        "objects": [
            {"name": "banana", "position": [0.45, -0.2], "yaw": 0.0},
            {"name": "bowl", "position": [0.5, 0.2]},
        ]
    },
    "instruction": "put the banana in the bowl",
    "goal": ["in(banana, bowl)"],
}
TWICE = """\
def there_and_there():
    grab_and_putin('banana', 'bowl')
    # once more
    grab_and_putin('block', 'bowl')
"""


def test_a_sentence_becomes_a_scored_rollout(service):
    plan = service.http.post("/plans", json=REQUEST).json()
    told = service.events(f"/plans/{plan['id']}/events")
    assert "".join(event.get("text", "") for event in told).startswith("    # 1: put the banana")
    plan = service.wait(f"/plans/{plan['id']}", "succeeded", "failed")
    assert (plan["status"], plan["error"]) == ("succeeded", None)
    execution = service.get(f"/executions/{plan['executions'][0]}")
    assert execution["scores"]["sr"] == plan["plan_scores"]["sr"] == 1
    trace = service.get(f"/executions/{execution['id']}/trace")["items"]
    assert [event["sequence"] for event in trace] == list(range(len(trace)))
    assert trace[-1]["kind"] == "execution_finished"
    frames = service.http.get(f"/executions/{execution['id']}/frames")
    assert int(frames.headers["frame-count"]) > 100


def test_a_plan_is_cancelled_while_the_model_writes(service):
    plan = service.http.post("/plans", json=REQUEST | {"instruction": "go on forever"}).json()
    service.events(f"/plans/{plan['id']}/events", until="completion_grew")
    service.http.post(f"/plans/{plan['id']}/cancel")
    assert service.events(f"/plans/{plan['id']}/events")[-1]["status"] == "cancelled"


def test_an_execution_is_cancelled_while_the_robot_moves(service):
    body = {"scene": REQUEST["scene"], "program": TWICE.replace("block", "banana")}
    plan = service.http.post("/plans", json=body).json()
    execution_id = plan["executions"][0]
    service.events(f"/executions/{execution_id}/events", until="stage_reached")
    assert service.http.post(f"/plans/{plan['id']}/cancel").status_code == 202
    assert service.events(f"/executions/{execution_id}/events")[-1]["status"] == "cancelled"
    assert service.wait(f"/plans/{plan['id']}", "cancelled")["error"] is None


def test_a_second_service_on_the_same_data_is_refused_with_the_reason(service):
    refused = subprocess.run(
        [sys.executable, "-m", "app.cli", "serve", "--port=0", f"--data-dir={service.data_dir}"],
        capture_output=True,
        text=True,
    )
    assert refused.returncode == 1
    assert "in use by another service" in refused.stderr


def test_a_port_in_use_is_refused_with_the_reason(service, tmp_path):
    port = service.url.rsplit(":", 1)[1]
    refused = subprocess.run(
        [sys.executable, "-m", "app.cli", "serve", f"--port={port}", f"--data-dir={tmp_path}"],
        capture_output=True,
        text=True,
    )
    assert refused.returncode == 1
    assert f"cannot listen on 127.0.0.1:{port}" in refused.stderr


def test_a_service_killed_in_the_middle_keeps_everything_and_finishes_what_was_under_way(service):
    before = service.get("/plans")["items"]
    plan = service.http.post("/plans", json=REQUEST).json()
    service.stop(signal.SIGKILL)
    service.start()
    after = service.get(
        "/plans",
    )["items"]
    assert after[1:] == before
    assert service.wait(f"/plans/{plan['id']}", "succeeded", "failed")["status"] == "succeeded"


@pytest.mark.parametrize("number", ENDINGS)
def test_a_service_that_ends_leaves_no_worker_behind_and_says_so(service, number):
    if service.process.poll() is not None:
        service.start()
    workers = [service.worker(name) for name in ("planning-1", "simulation-1")]
    code = service.stop(number)
    within_limit(lambda: not any(map(runs, workers)))
    if number != signal.SIGKILL:
        assert code == 0
        within_limit(lambda: service.lines[-1] == "stopped; everything is kept")
