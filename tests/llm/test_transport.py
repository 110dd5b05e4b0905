from datetime import UTC, datetime, timedelta
from email.utils import format_datetime

import httpx
import pytest

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.llm.transport import LONGEST_WAIT, Patience, Transport, sent_events


class Service:
    """Gives the answers it was made with, one a request; an exception is raised."""

    def __init__(self, *answers, jitter=0.0):
        self.answers = list(answers)
        self.requests = []
        self.waits = []
        self.transport = Transport(
            "https://models.test/v1/",
            headers={"Authorization": "Bearer secret"},
            patience=Patience(jitter=jitter),
            transport=httpx.MockTransport(self._answer),
            sleep=self.waits.append,
        )

    def _answer(self, request):
        self.requests.append(request)
        answer = self.answers.pop(0)
        if isinstance(answer, Exception):
            raise answer
        return answer


def good():
    return httpx.Response(200, json={"fine": True})


def test_json_is_sent_with_the_key_and_json_comes_back():
    service = Service(good())
    assert service.transport.post("completions", {"prompt": "a"}) == {"fine": True}
    (request,) = service.requests
    assert request.url == "https://models.test/v1/completions"
    assert request.headers["Authorization"] == "Bearer secret"
    assert request.content == b'{"prompt":"a"}'


def test_the_key_does_not_go_where_a_request_is_sent_on_to():
    moved = httpx.Response(307, headers={"Location": "https://elsewhere.test/v1/completions"})
    service = Service(moved, good())
    with pytest.raises(ModelUnavailable, match=r"moved to https://elsewhere\.test.*set that"):
        service.transport.post("completions", {})
    assert [request.url.host for request in service.requests] == ["models.test"]


@pytest.mark.parametrize(
    "trouble",
    [
        httpx.Response(429),
        httpx.Response(503),
        httpx.ConnectError("refused"),
        httpx.RemoteProtocolError("gone"),
    ],
)
def test_passing_trouble_is_waited_out(trouble):
    service = Service(trouble, trouble, good())
    assert service.transport.post("completions", {}) == {"fine": True}
    assert service.waits == [0.5, 1.0]


def test_wait_the_service_asks_for_is_kept_within_reason():
    asking = [httpx.Response(429, headers={"Retry-After": text}) for text in ("7", "9999", "soon")]
    service = Service(*asking, good())
    service.transport.post("completions", {})
    assert service.waits == [7.0, LONGEST_WAIT, 2.0]


def test_lasting_trouble_is_given_up_after_four_attempts():
    service = Service(*[httpx.Response(500, text="out of order") for _ in range(4)])
    with pytest.raises(ModelUnavailable, match=r"still 500 after several attempts.*out of order"):
        service.transport.post("completions", {})
    assert len(service.requests) == 4


def test_service_that_is_not_there_is_named():
    service = Service(*[httpx.ConnectError("refused")] * 4)
    with pytest.raises(ModelUnavailable, match=r"models\.test could not be reached: refused"):
        service.transport.post("completions", {})


@pytest.mark.parametrize("status", [401, 403])
def test_refused_key_is_said_at_once_and_the_key_is_not(status):
    service = Service(httpx.Response(status, json={"error": {"message": "bad key"}}))
    with pytest.raises(ModelUnavailable, match=r"the key was refused.*bad key") as raised:
        service.transport.post("completions", {})
    assert "secret" not in str(raised.value)
    assert service.waits == []


def test_unknown_model_is_said_with_the_address():
    service = Service(httpx.Response(404, json={"error": "no model x"}))
    with pytest.raises(ModelUnavailable, match=r"https://models\.test/v1/completions.*no model x"):
        service.transport.post("completions", {})


def test_refused_request_is_the_completions_fault():
    service = Service(httpx.Response(400, json={"error": {"message": "prompt too long"}}))
    with pytest.raises(CompletionFailed, match="prompt too long"):
        service.transport.post("completions", {})


@pytest.mark.parametrize("text", ["<html>", "[1]", ""])
def test_answer_that_is_no_json_object_is_shown(text):
    service = Service(httpx.Response(200, text=text))
    with pytest.raises(CompletionFailed, match="the answer is not"):
        service.transport.post("completions", {})


def test_silence_is_not_asked_again():
    service = Service(httpx.ReadTimeout("slow"))
    with pytest.raises(ModelUnavailable, match="sent nothing for 120 s"):
        service.transport.post("completions", {})


@pytest.mark.parametrize("url", ["models.test/v1", "ftp://models.test", "http://["])
def test_address_that_is_none_is_refused(url):
    with pytest.raises(ModelUnavailable, match="could not be reached"):
        Transport(url).post("completions", {})


def test_waits_are_lengthened_at_random_but_not_beyond_the_share():
    waits = []
    for _ in range(20):
        service = Service(httpx.Response(503), good(), jitter=0.5)
        service.transport.post("completions", {})
        waits += service.waits
    assert len(set(waits)) > 10
    assert all(0.5 <= wait <= 0.75 for wait in waits)


def test_date_that_ends_the_pause_is_understood():
    soon = format_datetime(datetime.now(UTC) + timedelta(seconds=20), usegmt=True)
    service = Service(httpx.Response(503, headers={"Retry-After": soon}), good())
    service.transport.post("completions", {})
    assert 15 < service.waits[0] <= 20


@pytest.mark.parametrize(
    ("status", "todo"), [(429, "rate limit or the quota"), (529, "overloaded"), (503, "overloaded")]
)
def test_lasting_trouble_says_what_to_do(status, todo):
    service = Service(*[httpx.Response(status)] * 4)
    with pytest.raises(ModelUnavailable, match=rf"still {status} .* {todo}"):
        service.transport.post("completions", {})


@pytest.mark.parametrize(
    "message", ["maximum context length is 4096 tokens", "prompt is too long: 9 > 8"]
)
def test_prompt_too_long_for_the_model_says_so(message):
    service = Service(httpx.Response(400, json={"error": {"message": message}}))
    with pytest.raises(CompletionFailed, match=r"too long .*use fewer objects or examples"):
        service.transport.post("completions", {})


def test_answer_that_breaks_off_is_told_apart_from_no_answer():
    def break_off():
        yield b'{"a": '
        raise httpx.ReadError("connection reset")

    service = Service(httpx.Response(200, content=break_off()))
    with pytest.raises(ModelUnavailable, match="broke off: connection reset; ask again"):
        service.transport.post("completions", {})


def test_sent_events_are_objects_and_the_end_an_empty_one():
    text = ': ping\n\nevent: a\ndata: {"n": 1}\n\ndata: [DONE]\n\n'
    assert list(sent_events(httpx.Response(200, text=text))) == [{"n": 1}, {}]
