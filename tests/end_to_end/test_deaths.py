"""Deaths without warning, while the model writes and while the robot moves."""

import os
import signal

import pytest

pytestmark = pytest.mark.physics

SCENE = {
    "objects": [
        {"name": "banana", "position": [0.45, -0.2], "yaw": 0.0},
        {"name": "bowl", "position": [0.5, 0.2]},
        {"name": "block"},
    ]
}
TWICE = """\
def there_and_there():
    grab_and_putin('banana', 'bowl')
    # once more
    grab_and_putin('block', 'bowl')
"""
DYING = ("the worker", "the service", "everything")


def kill(service, dying, worker_id):
    """Kill without warning; whoever has nobody left to start it again is started by hand."""
    worker = service.worker(worker_id)
    if dying == "the worker":
        os.kill(worker, signal.SIGKILL)
        return
    service.stop(signal.SIGKILL)
    if dying == "everything":
        for each in ("planning-1", "simulation-1"):
            os.kill(service.worker(each), signal.SIGKILL)
    service.start()


def numbers(story):
    return [event["sequence"] for event in story]


def written(story):
    return "".join(event.get("text", "") for event in story)


@pytest.mark.parametrize("dying", DYING)
def test_a_death_while_the_model_writes_loses_nothing_and_tells_nothing_twice(service, dying):
    body = {"scene": SCENE, "instruction": "take your time", "execute": False}
    path = service.http.post("/plans", json=body).headers["location"]
    seen = service.events(f"{path}/events", until="completion_grew")
    kill(service, dying, "planning-1")
    *rest, end = service.events(f"{path}/events", after=seen[-1]["sequence"])
    plan = service.get(path)
    assert (end["status"], plan["status"], plan["error"]) == ("planned", "planned", None)
    story = seen + rest
    assert numbers(story) == list(range(len(story)))
    assert len(written(seen)) < len(plan["completion"])
    assert written(story) == plan["completion"]
    others = [event["kind"] for event in story if event["kind"] != "completion_grew"]
    assert others == ["planning_started", "prompt_written", "program_grounded"]
    assert service.events(f"{path}/events")[:-1] == story


@pytest.mark.parametrize("dying", DYING)
def test_a_death_while_the_robot_moves_loses_nothing_and_tells_nothing_twice(service, dying):
    body = {"scene": SCENE, "program": TWICE, "execute": False, "goal": ["in(banana, bowl)"]}
    path = service.http.post("/plans", json=body).headers["location"] + "/executions"
    whole = service.http.post(path).headers["location"]
    service.wait(whole, "succeeded", "failed")
    broken = service.http.post(path).headers["location"]
    seen = service.events(f"{broken}/events", until="action_performed")
    kill(service, dying, "simulation-1")
    rest = service.events(f"{broken}/events", after=seen[-1]["sequence"])
    assert rest[-1]["status"] == service.get(whole)["status"]
    stories = [service.get(f"{one}/trace")["items"] for one in (whole, broken)]
    assert stories[1] == seen + rest[:-1]
    assert numbers(stories[1]) == list(range(len(stories[1])))
    plain = [[event | {"at": ""} for event in story] for story in stories]
    assert plain[1] == plain[0]
    films = [service.http.get(f"{one}/frames").content for one in (whole, broken)]
    assert films[1] == films[0]
