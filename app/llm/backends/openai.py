"""Any service that speaks the OpenAI protocol: hosted ones, vLLM, Ollama, llama.cpp's server."""

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Literal

import httpx

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import Completion, CompletionRequest, LanguageModel, OnText
from app.llm.backend import Endpoint, LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.transport import Transport, json_object

MOST_STOPS = 4
"""More stop words are refused by the hosted services."""
TO_CHAT = (
    "You complete Python programs. Answer with nothing but the text that continues the program"
    " where it breaks off: no fence, no explanation, nothing of what is already there."
)


class OpenAIModel:
    """One model of one service, asked for a completion of the bare prompt."""

    def __init__(self, endpoint: Endpoint, name: str, transport: Transport) -> None:
        self.name = name
        self.follows_grammar = endpoint.grammar
        self._endpoint = endpoint
        self._transport = transport

    def complete(self, request: CompletionRequest, on_text: OnText | None = None) -> Completion:
        """Continue the prompt; streamed where somebody watches."""
        started = time.perf_counter()
        path = "chat/completions" if self._endpoint.chat else "completions"
        body = self._body(request)
        answer = _Answer()
        if on_text is None:
            answer.take(self._transport.post(path, body))
        else:
            body |= {"stream": True, "stream_options": {"include_usage": True}}
            with self._transport.stream("POST", path, body=body) as response:
                for chunk in _chunks(response):
                    new = answer.take(chunk)
                    if new and on_text(new):
                        answer.finish = "cancelled"
                        break
        return Completion(
            text=answer.text,
            model=self.name,
            finish=answer.finish,
            prompt_tokens=answer.usage.get("prompt_tokens", 0),
            completion_tokens=answer.usage.get("completion_tokens", answer.pieces),
            seconds=time.perf_counter() - started,
        )

    def _body(self, request: CompletionRequest) -> dict[str, object]:
        body: dict[str, object] = {
            "model": self._endpoint.model,
            "max_tokens": request.max_tokens,
            "temperature": request.temperature,
            "seed": request.seed,
        }
        if request.stop:
            body["stop"] = list(request.stop[:MOST_STOPS])
        if request.grammar and self._endpoint.grammar:
            body["grammar"] = request.grammar
        if self._endpoint.chat:
            asked = {"role": "user", "content": request.prompt}
            return body | {"messages": [{"role": "system", "content": TO_CHAT}, asked]}
        return body | {"prompt": request.prompt}


@backends.register("openai")
class OpenAIBackend:
    """Connects nothing yet: the first request shows whether the service is there."""

    def open(self, spec: ModelSpec, config: LlmConfig) -> LanguageModel:
        """The model behind ``spec.endpoint``."""
        del config  # Unused.
        endpoint = spec.endpoint
        if endpoint is None:
            raise ModelUnavailable(f"{spec.name} has no endpoint; give its base URL and model")
        base_url = endpoint.base_url.rstrip("/") + "/"
        return OpenAIModel(endpoint, spec.name, Transport(base_url, key=endpoint.key))


@dataclass(slots=True)
class _Answer:
    """What has come so far."""

    text: str = ""
    pieces: int = 0
    finish: Literal["stop", "length", "cancelled"] = "stop"
    usage: dict[str, int] = field(default_factory=dict)

    def take(self, chunk: dict[str, Any]) -> str:
        """Add a chunk, or a whole answer; returns the text that is new."""
        if error := chunk.get("error"):
            said = error.get("message", error) if isinstance(error, dict) else error
            raise CompletionFailed(f"the service broke off: {said}")
        self.usage |= {k: v for k, v in (chunk.get("usage") or {}).items() if isinstance(v, int)}
        choices = chunk.get("choices")
        if not choices:  # the last chunk only tells the usage
            if not chunk.get("usage"):
                raise CompletionFailed(f"the answer has no choices: {str(chunk)[:200]}")
            return ""
        choice = choices[0]
        message = choice.get("delta") or choice.get("message") or {}
        new = choice.get("text") or message.get("content") or ""
        self.text += new
        self.pieces += bool(new)
        if choice.get("finish_reason") == "length":
            self.finish = "length"
        return new


def _chunks(response: httpx.Response) -> Iterator[dict[str, Any]]:
    """The objects in a stream of server-sent events."""
    for line in response.iter_lines():
        data = line.removeprefix("data:").strip()
        if line.startswith("data:") and data and data != "[DONE]":
            yield json_object(data)
