"""One test over every way of reaching a model: a new backend needs an opening here."""

import json
from http.server import BaseHTTPRequestHandler

import pytest

from app.domain.errors import ModelUnavailable
from app.domain.llm import CompletionRequest
from app.llm.backend import Endpoint
from app.llm.backends import backends
from app.llm.models import LlmConfig, open_model

WORDS = ["one", " two", " three", " four", " five", " six", " seven"]


class Service(BaseHTTPRequestHandler):
    """As much of the OpenAI protocol as a client sees."""

    def do_POST(self):
        asked = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        words = WORDS[: asked["max_tokens"]]
        end = {"finish_reason": "length" if len(words) < len(WORDS) else "stop"}
        if asked.get("stream"):
            pieces = [{"choices": [{"text": word}]} for word in words]
            events = [*pieces, {"choices": [{"text": "", **end}]}]
            body = "".join(f"data: {json.dumps(event)}\n\n" for event in events)
        else:
            usage = {"prompt_tokens": 3, "completion_tokens": len(words)}
            body = json.dumps({"choices": [{"text": "".join(words), **end}], "usage": usage})
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body.encode())

    def log_message(self, format, *args):
        pass


def open_scripted(request, tmp_path):
    script = tmp_path / "script.json"
    script.write_text(json.dumps([{"text": "".join(WORDS)}]))
    return open_model("scripted", LlmConfig(scripted_file=script))


def open_openai(request, tmp_path):
    url = request.getfixturevalue("serve")(Service)
    endpoint = Endpoint(base_url=f"{url}/v1", model="words")
    return open_model("words", LlmConfig(endpoints=(("words", endpoint),)))


class Messages(BaseHTTPRequestHandler):
    """As much of Anthropic's protocol as a client sees."""

    def do_POST(self):
        asked = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        words = WORDS[: asked["max_tokens"]]
        reason = "max_tokens" if len(words) < len(WORDS) else "end_turn"
        usage = {"input_tokens": 3, "output_tokens": len(words)}
        blocks = [{"type": "text", "text": word} for word in words]
        answer = {"content": blocks, "stop_reason": reason, "usage": usage}
        if asked.get("stream"):
            events = [
                *({"type": "content_block_delta", "delta": block} for block in blocks),
                {"type": "message_delta", "delta": {"stop_reason": reason}, "usage": usage},
                {"type": "message_stop"},
            ]
            body = "".join(f"data: {json.dumps(event)}\n\n" for event in events)
        else:
            body = json.dumps(answer)
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body.encode())

    def log_message(self, format, *args):
        pass


def open_anthropic(request, tmp_path):
    url = request.getfixturevalue("serve")(Messages)
    endpoint = Endpoint(protocol="anthropic", base_url=f"{url}/v1", model="words", key="k")
    return open_model("words", LlmConfig(endpoints=(("words", endpoint),)))


def open_local(request, tmp_path):
    return request.getfixturevalue("small_model")


OPENINGS = {
    "scripted": open_scripted,
    "openai": open_openai,
    "anthropic": open_anthropic,
    "local": open_local,
}
MARKS = {"local": [pytest.mark.model, pytest.mark.timeout(1800)]}


@pytest.fixture(params=[pytest.param(name, marks=MARKS.get(name, ())) for name in backends])
def model(request, tmp_path):
    return OPENINGS[request.param](request, tmp_path)


def test_it_completes_in_pieces_that_add_up(model):
    pieces = []
    asked = CompletionRequest(prompt="one, two, three", max_tokens=12)
    completion = model.complete(asked, lambda text: bool(pieces.append(text)))
    assert completion.text == "".join(pieces) != ""
    assert completion.model == model.name
    assert completion.finish in ("stop", "length")
    assert completion.seconds > 0


def test_it_gives_the_same_text_watched_or_not(model):
    asked = CompletionRequest(prompt="one, two, three", max_tokens=12)
    assert model.complete(asked).text == model.complete(asked, lambda text: False).text


def test_it_keeps_to_the_tokens_allowed(model):
    completion = model.complete(CompletionRequest(prompt="one, two, three", max_tokens=3))
    assert completion.finish == "length"
    assert completion.completion_tokens == 3


def test_it_stops_when_asked_to(model):
    pieces = []

    def stop(text):
        pieces.append(text)
        return "".join(pieces).strip() != ""

    asked = CompletionRequest(prompt="one, two, three", max_tokens=200)
    completion = model.complete(asked, stop)
    assert completion.finish == "cancelled"
    assert completion.text == "".join(pieces)


def test_it_scores_the_likelier_candidate_higher_or_says_why_not(model):
    if model.name == "words":  # these services tell no probabilities
        with pytest.raises(ModelUnavailable, match="local model"):
            model.score("one, two, three,", [" four", " nine hundred"])
    else:
        likely, odd = model.score("one, two, three,", [" four", " nine hundred"])
        assert likely > odd
