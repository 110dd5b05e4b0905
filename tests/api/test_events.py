import json
import threading

import pytest

from app.domain.trace import CompletionGrew
from app.storage import events, plans


def messages(lines):
    """The messages of a stream, as (id, type, data)."""
    number, kind, data = None, "message", None
    for line in lines:
        name, _, value = line.partition(": ")
        if name == "id":
            number = int(value)
        elif name == "event":
            kind = value
        elif name == "data":
            data = json.loads(value)
        elif not line and data is not None:
            yield number, kind, data
            number, kind, data = None, "message", None


def follow(client, path, **headers):
    with client.stream("GET", path, headers=headers) as answer:
        assert answer.headers["content-type"].startswith("text/event-stream")
        return list(messages(answer.iter_lines()))


@pytest.mark.parametrize("owner", ["plans", "executions"])
def test_a_stream_tells_every_event_once_in_order_and_then_ends(client, executed, owner):
    path = f"/{owner}/{executed[owner == 'executions']}/events"
    *told, (number, kind, data) = follow(client, path)
    assert [number for number, _, _ in told] == list(range(len(told)))
    assert [data["sequence"] for _, _, data in told] == list(range(len(told)))
    assert (number, kind, data["status"]) == (None, "end", "succeeded")


def test_a_stream_goes_on_after_the_last_event_a_client_has_seen(client, executed):
    path = f"/executions/{executed[1]}/events"
    whole = follow(client, path)
    assert follow(client, path, **{"Last-Event-ID": "2"}) == whole[3:]


def test_a_client_that_has_seen_the_end_is_told_not_to_come_back(client, executed):
    path = f"/executions/{executed[1]}/events"
    last = follow(client, path)[-2][0]
    assert client.get(path, headers={"Last-Event-ID": str(last)}).status_code == 204


@pytest.mark.parametrize("last", ["", "-1", "x", "9" * 50])
def test_a_last_event_id_that_is_none_begins_at_the_beginning(client, executed, last):
    told = follow(client, f"/executions/{executed[1]}/events", **{"Last-Event-ID": last})
    assert told[0][0] == 0


def test_a_stream_tells_what_happens_while_it_is_open(client, parts, request_body):
    plan_id = client.post("/plans", json=request_body).json()["id"]
    written = threading.Event()

    def write():
        for number in range(3):
            with parts.database.transaction() as session:
                events.append(session, plan_id, number, [CompletionGrew(text=str(number))])
            assert written.wait(30)
            written.clear()
        with parts.database.transaction() as session:
            plans.get(session, plan_id).status = "failed"

    writer = threading.Thread(target=write)
    told = []
    with client.stream("GET", f"/plans/{plan_id}/events") as answer:
        writer.start()
        for _, _, data in messages(answer.iter_lines()):
            told.append(data.get("text", data["kind"]))
            written.set()
    writer.join()
    assert told == ["0", "1", "2", "end"]


def test_conditions_and_facts_are_told_in_the_syntax_of_goals(client, executed):
    told = {
        data["kind"]: data for _, _, data in follow(client, f"/executions/{executed[1]}/events")
    }
    assert told["goal_checked"]["condition"] == "in(banana, bowl)"
    assert told["execution_finished"]["facts"] == ["in(banana, bowl)"]


def test_the_trace_comes_in_parts_in_the_order_of_time(client, executed):
    path, seen, cursor = f"/executions/{executed[1]}/trace", [], None
    while True:
        page = client.get(path, params={"limit": 2} | ({"cursor": cursor} if cursor else {})).json()
        seen += page["items"]
        cursor = page["next"]
        if cursor is None:
            break
    assert [event["sequence"] for event in seen] == list(range(len(seen)))
    assert seen[0]["kind"] == "execution_started"
    assert seen == client.get(path).json()["items"]
