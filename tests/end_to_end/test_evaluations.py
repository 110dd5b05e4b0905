"""An evaluation in the service, through the death of the worker it runs in."""

import os
import signal

import pytest

pytestmark = pytest.mark.physics

REQUEST = {
    "suite": "robot-tasks",
    "planners": [{"name": "progprompt", "model": "scripted"}],
    "limit": 12,
    "runs": 2,
}


def test_killing_the_planning_worker_loses_no_attempt_and_makes_none_twice(service):
    place = service.http.post("/evaluations", json=REQUEST).headers["location"]
    service.wait(place, "running")
    os.kill(service.worker("planning-1"), signal.SIGKILL)
    found = service.wait(place, "succeeded", "failed")
    assert (found["status"], found["done"], found["error"]) == ("succeeded", 24, None)
    results = service.get(f"{place}/results")["items"]
    assert [result["index"] for result in results] == list(range(24))
    assert len({result["key"] for result in results}) == 24
    assert not any("died" in result["reason"] for result in results)
