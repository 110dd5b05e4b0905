import re

import pytest
from sqlalchemy import event

from app.domain.trace import ActionStarted, Frame
from app.storage import events, executions, frames
from app.storage.base import now
from app.storage.events import EventRow

PROGRAM = "def f():\n    grab_and_putin('banana', 'bowl')\n"


@pytest.fixture
def queued(client, request_body):
    plan = client.post("/plans", json=request_body | {"program": PROGRAM}).json()
    return plan["id"], plan["executions"][0]


def test_an_execution_tells_what_became_of_every_step(client, executed):
    execution = client.get(f"/executions/{executed[1]}").json()
    [step] = execution["steps"]
    assert (step["line"], step["outcome"], step["attempts"]) == (4, "performed", 1)
    assert execution["scores"] == {"sr": 1, "gcr": 1, "exec": 1, "precision": 1}
    assert execution["final_state"] == ["in(banana, bowl)"]
    assert (execution["failure"], execution["error"]) == (None, None)


def test_steps_to_come_are_pending(client, queued):
    execution = client.get(f"/executions/{queued[1]}").json()
    assert (execution["status"], execution["steps"][0]["outcome"]) == ("queued", "pending")


def test_a_step_that_never_ended_is_stopped_with_its_execution(client, parts, queued):
    _, execution_id = queued
    step = ActionStarted(line=2, action="grab_and_putin", arguments=("banana", "bowl"), time=0.0)
    outcomes = []
    for status in ("executing", "cancelled"):
        with parts.database.transaction() as session:
            executions.change(session, execution_id, when=executions.UNFINISHED, status=status)
            events.append(session, execution_id, 0, [step])
        outcomes += client.get(f"/executions/{execution_id}").json()["steps"]
    assert [step["outcome"] for step in outcomes] == ["running", "stopped"]


def test_a_failed_execution_tells_line_stage_and_reason(client, request_body, carry_out):
    program = (
        "def f():\n"
        "    grab_and_putin('bowl', 'banana')\n"
        "    # the bowl is on it now\n"
        "    grab_and_putin('banana', 'bowl')\n"
    )
    plan = client.post("/plans", json=request_body | {"program": program}).json()
    carry_out(plan["executions"][0])
    execution = client.get(f"/executions/{plan['executions'][0]}").json()
    assert execution["status"] == "failed"
    assert execution["failure"]["line"] == 4
    assert (execution["failure"]["stage"], execution["steps"][1]["outcome"]) == ("check", "failed")
    assert "not reached: in(banana, bowl)" in execution["error"]
    assert client.get(f"/plans/{plan['id']}").json()["error"] == execution["error"]


def test_a_queued_execution_is_cancelled_at_once_and_its_plan_with_it(client, queued, carry_out):
    plan_id, execution_id = queued
    assert client.post(f"/executions/{execution_id}/cancel").json()["status"] == "cancelled"
    carry_out(execution_id)
    assert client.get(f"/executions/{execution_id}").json()["status"] == "cancelled"
    assert client.get(f"/plans/{plan_id}").json()["status"] == "cancelled"


def test_an_execution_that_is_over_cannot_be_cancelled(client, executed, problem_of):
    problem_of(client.post(f"/executions/{executed[1]}/cancel"), 409)


def test_a_cancelled_plan_can_be_carried_out_anew(client, queued, carry_out):
    plan_id, _ = queued
    client.post(f"/plans/{plan_id}/cancel")
    second = client.post(f"/plans/{plan_id}/executions").json()["id"]
    carry_out(second)
    assert client.get(f"/executions/{second}").json()["status"] == "succeeded"


def test_executions_can_be_listed_by_plan(client, executed, queued):
    listed = client.get("/executions", params={"plan_id": queued[0]}).json()["items"]
    assert [execution["id"] for execution in listed] == [queued[1]]


@pytest.fixture
def statements(parts):
    """What the database was asked since."""
    asked = []

    def note(connection, cursor, statement, *_):
        asked.append(statement)

    event.listen(parts.database.engine, "before_cursor_execute", note)
    yield asked
    event.remove(parts.database.engine, "before_cursor_execute", note)


def test_a_long_list_asks_no_more_of_the_database_than_a_short_one(client, queued, statements):
    plan_id, _ = queued

    def listed():
        statements.clear()
        return len(client.get("/executions").json()["items"]), len(statements)

    one, asked = listed()
    client.post(f"/plans/{plan_id}/executions")
    assert listed() == (one + 1, asked)


def test_a_list_does_not_read_what_tells_nothing_of_the_steps(client, parts, queued):
    with parts.database.transaction() as session:
        row = EventRow(owner=queued[1], sequence=0, at=now(), kind="stage_reached", body={})
        session.add(row)
    assert client.get("/executions").json()["items"][0]["steps"][0]["outcome"] == "pending"


def test_frames_are_told_as_packed_numbers_from_any_index_on(client, parts, queued):
    with parts.database.transaction() as session:
        moments = [Frame(time=float(n), positions=(1.0, 2.0)) for n in range(5)]
        frames.append(session, queued[1], 0, moments)
        executions.get(session, queued[1])
    answer = client.get(f"/executions/{queued[1]}/frames", params={"start": 2})
    assert (answer.headers["frame-width"], answer.headers["frame-count"]) == ("3", "3")
    assert len(answer.content) == 3 * 3 * 4


@pytest.mark.physics
def test_a_recording_is_a_file_to_download(client, request_body):
    body = request_body | {"program": PROGRAM}
    body["scene"] = body["scene"] | {"world": "tabletop"}
    execution_id = client.post("/plans", json=body).json()["executions"][0]
    answer = client.get(f"/executions/{execution_id}/recording")
    assert answer.status_code == 200
    assert f"{execution_id}.viser" in answer.headers["content-disposition"]
    assert len(answer.content) > 1000


def test_a_world_without_motion_has_no_recording(client, executed, problem_of):
    problem_of(client.get(f"/executions/{executed[1]}/recording"), 404)


def test_a_what_if_begins_at_a_line_of_its_program(client, executed, problem_of):
    plan_id, execution_id = executed
    body = {"after": execution_id, "line": 99}
    [fault] = problem_of(client.post(f"/plans/{plan_id}/executions", json=body), 422)["errors"]
    assert fault["field"] == "line"
    assert re.search(r"ends with line (\d+); give 1 to \1", fault["message"])


def test_numbers_beyond_what_a_database_holds_are_refused(client, executed, problem_of):
    plan_id, execution_id = executed
    for line in (2**31, 10**30):
        body = {"after": execution_id, "line": line}
        problem_of(client.post(f"/plans/{plan_id}/executions", json=body), 422)
    problem_of(client.get(f"/executions/{execution_id}/frames", params={"start": 2**31}), 422)
    problem_of(client.get(f"/executions/{execution_id}/trace", params={"cursor": 2**31}), 422)
