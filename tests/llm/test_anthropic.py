import json

import httpx
import pytest

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import CompletionRequest
from app.llm.backend import Endpoint, LlmConfig, ModelSpec
from app.llm.backends.anthropic import AnthropicBackend, AnthropicModel
from app.llm.transport import Patience, Transport

URL = "https://llm.test/v1"
REQUEST = CompletionRequest(
    prompt="def f():\n", max_tokens=9, stop=("\n\n", "\ndef "), temperature=1.7
)


def model(*answers):
    """A model whose service gives the answers in turn, and the list of what it was asked."""
    asked, left = [], list(answers)

    def respond(request):
        asked.append((request.url.path, json.loads(request.content)))
        return left.pop(0) if len(left) > 1 else left[0]

    transport = Transport(
        f"{URL}/",
        patience=Patience(jitter=0.0),
        transport=httpx.MockTransport(respond),
        sleep=lambda seconds: None,
    )
    endpoint = Endpoint(protocol="anthropic", base_url=URL, model="big", key="secret")
    return AnthropicModel(endpoint, "mine", transport), asked


def whole(text, reason="end_turn"):
    usage = {"input_tokens": 10, "cache_read_input_tokens": 2, "output_tokens": 3}
    content = [{"type": "text", "text": text}]
    return httpx.Response(200, json={"content": content, "stop_reason": reason, "usage": usage})


def stream(*texts, reason="end_turn", end=True, more=()):
    deltas = [
        {"type": "content_block_delta", "delta": {"type": "text_delta", "text": text}}
        for text in texts
    ]
    last = {"type": "message_delta", "delta": {"stop_reason": reason}}
    events = [
        {"type": "message_start", "message": {"usage": {"input_tokens": 12, "output_tokens": 1}}},
        {"type": "ping"},
        *deltas,
        *more,
        *([last | {"usage": {"output_tokens": 5}}, {"type": "message_stop"}] if end else []),
    ]
    lines = [f"event: {event['type']}\ndata: {json.dumps(event)}\n\n" for event in events]
    return httpx.Response(200, text="".join(lines))


def test_prompt_is_one_message_after_a_word_on_how_to_go_on():
    mine, asked = model(whole("    pass\n"))
    completion = mine.complete(REQUEST)
    assert (completion.text, completion.finish, completion.model) == ("    pass\n", "stop", "mine")
    assert (completion.prompt_tokens, completion.completion_tokens) == (12, 3)
    ((path, body),) = asked
    assert path == "/v1/messages"
    assert body.pop("system").startswith("You continue texts")
    assert body == {
        "model": "big",
        "max_tokens": 9,
        "temperature": 1.0,
        "messages": [{"role": "user", "content": "def f():\n"}],
        "stop_sequences": ["\ndef "],
    }


def test_streamed_pieces_are_passed_on_and_add_up():
    mine, asked = model(stream("é", "漢"))
    pieces = []
    completion = mine.complete(REQUEST, lambda text: bool(pieces.append(text)))
    assert pieces == ["é", "漢"]
    assert (completion.text, completion.finish) == ("é漢", "stop")
    assert (completion.prompt_tokens, completion.completion_tokens) == (12, 5)
    assert asked[0][1]["stream"] is True


@pytest.mark.parametrize("watch", [None, lambda text: False])
def test_blank_stop_words_which_the_service_refuses_are_minded_here(watch):
    text = ("a\n", "\nb")
    mine, _ = model(whole("".join(text)) if watch is None else stream(*text))
    completion = mine.complete(REQUEST, watch)
    assert completion.text.rstrip("\n") == "a"
    assert completion.finish == "stop"


@pytest.mark.parametrize("reason", ["max_tokens", "model_context_window_exceeded"])
def test_truncated_answer_is_told(reason):
    assert model(whole("a", reason))[0].complete(REQUEST).finish == "length"
    mine, _ = model(stream("a", reason=reason))
    assert mine.complete(REQUEST, lambda text: False).finish == "length"


def test_stream_is_left_when_asked_to_stop():
    mine, _ = model(stream("a", "b", "c"))
    completion = mine.complete(REQUEST, lambda text: text == "b")
    assert (completion.text, completion.finish) == ("ab", "cancelled")


def test_stream_that_breaks_off_is_no_answer():
    mine, _ = model(stream("a", end=False))
    with pytest.raises(CompletionFailed, match="broke off in the middle"):
        mine.complete(REQUEST, lambda text: False)


def test_trouble_in_the_middle_of_a_stream_is_told():
    error = {"type": "error", "error": {"type": "overloaded_error", "message": "Overloaded"}}
    mine, _ = model(stream("a", more=[error], end=False))
    with pytest.raises(CompletionFailed, match=r"broke off \(overloaded_error\): Overloaded"):
        mine.complete(REQUEST, lambda text: False)


def test_refusal_is_no_plan():
    with pytest.raises(CompletionFailed, match="refuses to answer"):
        model(whole("", "refusal"))[0].complete(REQUEST)


def failing(status, message="no"):
    error = {"type": "error", "error": {"type": "x", "message": message}}
    return httpx.Response(status, json=error)


@pytest.mark.parametrize(
    ("status", "error", "said"),
    [
        (401, ModelUnavailable, "the key was refused"),
        (403, ModelUnavailable, "the key was refused"),
        (404, ModelUnavailable, "no such model"),
        (429, ModelUnavailable, "rate limit or the quota"),
        (529, ModelUnavailable, "overloaded"),
        (413, CompletionFailed, "too long"),
        (400, CompletionFailed, "was refused"),
    ],
)
def test_every_refusal_ends_in_a_clear_state(status, error, said):
    mine, asked = model(failing(status))
    with pytest.raises(error, match=said):
        mine.complete(REQUEST)
    assert len(asked) == (4 if status in (429, 529) else 1)


def test_overload_that_passes_is_waited_out():
    mine, asked = model(failing(529), failing(429), whole("a"))
    assert mine.complete(REQUEST).text == "a"
    assert len(asked) == 3


def test_it_says_that_it_cannot_score():
    mine, asked = model(whole("a"))
    with pytest.raises(ModelUnavailable, match="does not tell probabilities"):
        mine.score("a", ["b"])
    assert asked == []


@pytest.mark.parametrize(
    ("endpoint", "said"),
    [
        (None, "has no endpoint"),
        (Endpoint(protocol="anthropic", base_url=URL, model="m"), "set PROGPROMPT_ANTHROPIC_KEY"),
    ],
)
def test_without_endpoint_or_key_it_is_not_opened(endpoint, said):
    spec = ModelSpec(name="mine", backend="anthropic", title="", endpoint=endpoint)
    with pytest.raises(ModelUnavailable, match=said):
        AnthropicBackend().open(spec, LlmConfig())


@pytest.mark.parametrize("answer", [{}, {"content": None}])
def test_answer_without_content_is_shown(answer):
    with pytest.raises(CompletionFailed, match="no content"):
        model(httpx.Response(200, json=answer))[0].complete(REQUEST)
