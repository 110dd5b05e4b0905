"""The viewer's endpoints over real sockets."""

import json

import httpx
import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

BLOCK = "/world/2"


@pytest.fixture
def http(address):
    with httpx.Client(base_url=f"http://{address}", timeout=20) as client:
        yield client


@pytest.fixture
def playhead(address):
    with connect(f"ws://{address}/viewer/done/page/playhead") as socket:
        yield socket


def until(socket, true):
    """The first moment told of which this is true."""
    while not true(moment := json.loads(socket.recv(timeout=20))):
        pass
    return moment


def ending(socket):
    """Code and reason with which the service closes the socket."""
    with pytest.raises(ConnectionClosed) as closed:
        until(socket, lambda _: False)
    assert closed.value.rcvd
    return closed.value.rcvd.code, closed.value.rcvd.reason


def test_page_of_a_rollout_is_visers_client(http):
    answer = http.get("/viewer/done/page/")
    assert answer.headers["content-type"].startswith("text/html")
    assert "<script" in answer.text


def test_visers_client_is_packed_and_not_sent_to_who_has_it(http):
    path = "/viewer/done/page/"
    packed = http.get(path, headers={"Accept-Encoding": "gzip"})
    plain = http.get(path, headers={"Accept-Encoding": "identity"})
    assert packed.text == plain.text
    sizes = [int(each.headers["content-length"]) for each in (packed, plain)]
    assert sizes[0] < 0.9 * sizes[1]
    again = http.get("/viewer/done/other/", headers={"If-None-Match": plain.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")


def test_rollout_has_a_page_of_its_own_with_controls(http):
    answer = http.get("/viewer/done/")
    assert answer.headers["content-type"].startswith("text/html")
    assert "/static/js/alone.js" in answer.text


def test_address_without_slash_leads_to_the_page(http):
    answer = http.get("/viewer/done")
    assert answer.is_redirect
    assert answer.headers["location"].endswith("/viewer/done/")


def test_unknown_execution_is_a_problem_document(http):
    for path in ("/viewer/nope/", "/viewer/nope/page/"):
        answer = http.get(path)
        assert answer.status_code == 404
        assert answer.json()["detail"] == "there is no execution 'nope'"


def test_browser_sees_the_rollout_through_the_service(address, open_browser):
    browser = open_browser(f"ws://{address}/viewer/done/page")
    browser.watch(lambda seen: any(place[2] > 1.06 for place in seen.positions.get(BLOCK, ())))
    assert browser.socket.subprotocol.startswith("viser-v")


def test_playhead_tells_where_it_is_and_goes_where_it_is_sent(address, playhead, open_browser):
    browser = open_browser(f"ws://{address}/viewer/done/page")
    browser.watch(lambda seen: seen.glbs)
    playhead.send(json.dumps({"mode": "paused", "time": 0.5}))
    moment = until(playhead, lambda told: told["time"] == 0.5)
    assert moment["mode"] == "paused"
    assert moment["finished"]
    assert moment["drawn"]
    assert moment["duration"] == pytest.approx(29 / 30, abs=1e-3)
    browser.watch(lambda seen: seen.positions[BLOCK][-1][2] == pytest.approx(0.6, abs=1e-3))


@pytest.mark.parametrize("command", ["nonsense", '{"time": -1}', '{"speed": 0}', '{"x": 1}'])
def test_malformed_command_ends_the_playhead_with_the_reason(playhead, command):
    playhead.send(command)
    code, reason = ending(playhead)
    assert code == 4400
    assert reason


def test_socket_of_an_unknown_execution_is_closed_with_the_reason(address):
    for path in ("/viewer/nope/page/playhead", "/viewer/nope/page"):
        with connect(f"ws://{address}{path}") as socket:
            assert ending(socket) == (4404, "there is no execution 'nope'")
