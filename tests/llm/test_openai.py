import json
from dataclasses import replace

import httpx
import pytest

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import CompletionRequest
from app.llm.backend import Endpoint, LlmConfig, ModelSpec
from app.llm.backends.openai import OpenAIBackend, OpenAIModel
from app.llm.transport import Transport

REQUEST = CompletionRequest(
    prompt="def f():\n", max_tokens=9, stop=tuple("abcdef"), seed=3, grammar='root ::= "x"'
)


def model(answer, *, chat=False, grammar=False):
    """A model whose service gives ``answer``, and the list of what it was asked."""
    asked = []

    def respond(request):
        asked.append((request.url.path, json.loads(request.content)))
        return answer

    endpoint = Endpoint(base_url="http://llm.test/v1", model="big", chat=chat, grammar=grammar)
    carrier = httpx.MockTransport(respond)
    return OpenAIModel(endpoint, "mine", Transport("http://llm.test/v1/", transport=carrier)), asked


def stream(*chunks):
    lines = [f"data: {json.dumps(chunk)}\n\n" for chunk in chunks]
    return httpx.Response(200, text=": hello\n\n" + "".join(lines) + "data: [DONE]\n\n")


def piece(text, **more):
    return {"choices": [{"text": text, **more}]}


def test_whole_answer_is_taken_with_its_usage():
    usage = {"prompt_tokens": 12, "completion_tokens": 3, "details": {"cached": 0}}
    answer = {"choices": [{"text": "pass\n", "finish_reason": "length"}], "usage": usage}
    mine, asked = model(httpx.Response(200, json=answer))
    completion = mine.complete(REQUEST)
    assert (completion.text, completion.finish, completion.model) == ("pass\n", "length", "mine")
    assert (completion.prompt_tokens, completion.completion_tokens) == (12, 3)
    ((path, body),) = asked
    assert path == "/v1/completions"
    assert body == {
        "model": "big",
        "prompt": "def f():\n",
        "max_tokens": 9,
        "temperature": 0.0,
        "seed": 3,
        "stop": ["a", "b", "c", "d"],
    }


def test_streamed_pieces_are_passed_on_and_add_up():
    usage = {"choices": [], "usage": {"prompt_tokens": 4, "completion_tokens": 2}}
    mine, asked = model(stream(piece("é"), piece("漢"), piece("", finish_reason="stop"), usage))
    pieces = []
    completion = mine.complete(REQUEST, lambda text: bool(pieces.append(text)))
    assert pieces == ["é", "漢"]
    assert (completion.text, completion.finish) == ("é漢", "stop")
    assert (completion.prompt_tokens, completion.completion_tokens) == (4, 2)
    assert asked[0][1]["stream"] is True


def test_stream_is_left_when_asked_to_stop():
    mine, _ = model(stream(piece("a"), piece("b"), piece("c")))
    completion = mine.complete(REQUEST, lambda text: text == "b")
    assert (completion.text, completion.finish, completion.completion_tokens) == (
        "ab",
        "cancelled",
        2,
    )


def test_chat_only_service_is_sent_one_message_and_its_answer_is_kept_as_it_is():
    answer = {"choices": [{"message": {"content": "```python\npass\n```"}}]}
    mine, asked = model(httpx.Response(200, json=answer), chat=True)
    assert mine.complete(REQUEST).text == "```python\npass\n```"
    ((path, body),) = asked
    assert path == "/v1/chat/completions"
    assert body["messages"][-1] == {"role": "user", "content": "def f():\n"}
    assert "prompt" not in body


def test_streamed_chat_adds_up():
    chunks = [{"choices": [{"delta": {"content": text}}]} for text in ("pa", "ss")]
    mine, _ = model(stream({"choices": [{"delta": {"role": "assistant"}}]}, *chunks), chat=True)
    assert mine.complete(REQUEST, lambda text: False).text == "pass"


@pytest.mark.parametrize("grammar", [True, False])
def test_grammar_goes_to_services_that_take_one(grammar):
    mine, asked = model(httpx.Response(200, json=piece("x")), grammar=grammar)
    mine.complete(REQUEST)
    assert ("grammar" in asked[0][1]) is grammar
    assert mine.follows_grammar is grammar


def test_error_in_the_middle_of_a_stream_is_told():
    mine, _ = model(stream(piece("a"), {"error": {"message": "out of memory"}}))
    with pytest.raises(CompletionFailed, match="out of memory"):
        mine.complete(REQUEST, lambda text: False)


@pytest.mark.parametrize("answer", [{}, {"choices": []}, {"choices": None}])
def test_answer_without_choices_is_shown(answer):
    mine, _ = model(httpx.Response(200, json=answer))
    with pytest.raises(CompletionFailed, match="no choices"):
        mine.complete(REQUEST)


def test_model_without_endpoint_cannot_be_opened():
    spec = ModelSpec(name="mine", backend="openai", title="")
    with pytest.raises(ModelUnavailable, match="mine has no endpoint"):
        OpenAIBackend().open(spec, LlmConfig())


def test_key_is_not_shown_where_the_endpoint_is():
    endpoint = Endpoint(base_url="http://llm.test/v1", model="big", key="secret")
    assert "secret" not in repr(LlmConfig(endpoints=(("big", endpoint),)))


def test_stream_that_breaks_off_is_no_answer():
    text = f"data: {json.dumps(piece('a'))}\n\n"
    mine, _ = model(httpx.Response(200, text=text))
    with pytest.raises(CompletionFailed, match="mine broke off in the middle"):
        mine.complete(REQUEST, lambda text: False)


@pytest.mark.parametrize(
    "told",
    [
        {"token_logprobs": [-1.0, -2.0]},
        {"content": [{"token": "x", "logprob": -1.0}, {"token": "y", "logprob": -2.0}]},
    ],
)
def test_mean_log_probability_is_told_where_it_was_asked_for(told):
    mine, asked = model(httpx.Response(200, json=piece("xy", logprobs=told)))
    assert mine.complete(replace(REQUEST, logprob=True)).logprob == -1.5
    assert asked[0][1]["logprobs"] == 1
    silent, asked = model(httpx.Response(200, json=piece("xy")))
    assert silent.complete(REQUEST).logprob is None
    assert "logprobs" not in asked[0][1]


def echoed(text, *tokens):
    starts = [sum(len(token) for token, _ in tokens[:n]) for n in range(len(tokens))]
    told = {"text_offset": starts, "token_logprobs": [value for _, value in tokens]}
    return piece(text, logprobs=told)


def test_candidates_are_scored_by_their_own_tokens_alone():
    cup = echoed("the cup.", ("the", None), (" cup", -1.0), (".", -9.0))
    bowl = echoed("the bowl.", ("the", None), (" bo", -0.5), ("wl", -0.25), (".", -9.0))
    choices = [{**bowl["choices"][0], "index": 1}, {**cup["choices"][0], "index": 0}]
    mine, asked = model(httpx.Response(200, json={"choices": choices}))
    assert mine.score("the", [" cup", " bowl"]) == (-1.0, -0.75)
    assert asked[0][1]["prompt"] == ["the cup", "the bowl"]
    assert asked[0][1]["echo"] is True


@pytest.mark.parametrize("answer", [piece("x"), echoed("x", ("x", -1.0)), {"choices": []}])
def test_service_that_does_not_echo_cannot_score(answer):
    mine, _ = model(httpx.Response(200, json=answer))
    with pytest.raises(ModelUnavailable, match="use a local model"):
        mine.score("the", [" cup"])


def test_chat_cannot_score_and_is_not_asked():
    mine, asked = model(httpx.Response(200, json=piece("x")), chat=True)
    with pytest.raises(ModelUnavailable, match="only takes chats"):
        mine.score("the", [" cup"])
    assert asked == []
