"""Any service that speaks the OpenAI protocol: hosted ones, vLLM, Ollama, llama.cpp's server."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import Completion, CompletionRequest, LanguageModel, OnText
from app.llm.backend import TO_CHAT, Endpoint, LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.transport import Transport, sent_events

MOST_STOPS = 4
"""More stop words are refused by the hosted services."""
SCORERS = "use a local model, or a completion service that echoes prompts with log-probabilities"


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
                for chunk in sent_events(response):
                    new = answer.take(chunk) if chunk else answer.end()
                    if new and on_text(new):
                        answer.finish = "cancelled"
                        break
            if not answer.ended and answer.finish != "cancelled":
                raise CompletionFailed(
                    f"{self.name} broke off in the middle of its answer; ask again"
                )
        return Completion(
            text=answer.text,
            model=self.name,
            finish=answer.finish,
            prompt_tokens=answer.usage.get("prompt_tokens", 0),
            completion_tokens=answer.usage.get("completion_tokens", answer.pieces),
            seconds=time.perf_counter() - started,
            logprob=answer.mean_logprob,
        )

    def score(self, prompt: str, candidates: Sequence[str]) -> tuple[float, ...]:
        """The candidates' log-probabilities [nat], from a service that echoes prompts with theirs.

        vLLM and the hosted completion models do; chats, llama.cpp's server and Ollama do not.
        """
        if self._endpoint.chat:
            raise ModelUnavailable(f"{self.name} only takes chats, which cannot score; {SCORERS}")
        asked = [prompt + candidate for candidate in candidates]
        body = {
            "model": self._endpoint.model,
            "prompt": asked,
            "max_tokens": 1,
            "temperature": 0.0,
            "echo": True,
            "logprobs": 1,
        }
        answer = self._transport.post("completions", body) if asked else {"choices": []}
        choices = answer.get("choices")
        if not isinstance(choices, list) or len(choices) != len(asked):
            raise ModelUnavailable(f"{self.name} does not score texts; {SCORERS}")
        choices.sort(key=lambda choice: choice.get("index", 0))
        pairs = zip(choices, asked, strict=True)
        return tuple(self._logprob(choice, len(prompt), len(text)) for choice, text in pairs)

    def _logprob(self, choice: dict[str, Any], start: int, end: int) -> float:
        """The sum over the tokens that reach into ``[start, end)`` of the echoed text."""
        told = choice.get("logprobs") or {}
        try:
            starts, values = told["text_offset"], told["token_logprobs"]
            ends = [*starts[1:], len(choice["text"])]
            spans = list(zip(starts, ends, values, strict=True))
        except (TypeError, KeyError, ValueError) as error:
            raise ModelUnavailable(f"{self.name} does not score texts; {SCORERS}") from error
        if len(choice["text"]) < end:
            raise ModelUnavailable(f"{self.name} does not echo its prompt; {SCORERS}")
        within = [value for first, last, value in spans if last > start and first < end]
        return float(sum(value for value in within if value is not None))

    def _body(self, request: CompletionRequest) -> dict[str, object]:
        body: dict[str, object] = {
            "model": self._endpoint.model,
            "max_tokens": request.max_tokens,
            "temperature": request.temperature,
            "seed": request.seed,
        }
        if request.stop:
            body["stop"] = list(request.stop[:MOST_STOPS])
        if request.logprob:
            body["logprobs"] = True if self._endpoint.chat else 1
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
        headers = {"Authorization": f"Bearer {endpoint.key}"} if endpoint.key else {}
        return OpenAIModel(endpoint, spec.name, Transport(base_url, headers=headers))


@dataclass(slots=True)
class _Answer:
    """What has come so far."""

    text: str = ""
    logprobs: list[float] = field(default_factory=list)
    pieces: int = 0
    ended: bool = False
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
        self.logprobs += _token_logprobs(choice)
        self.ended = self.ended or bool(choice.get("finish_reason"))
        if choice.get("finish_reason") == "length":
            self.finish = "length"
        return new

    def end(self) -> str:
        """Nothing more comes."""
        self.ended = True
        return ""

    @property
    def mean_logprob(self) -> float | None:
        """Over the tokens written [nat], where the service tells."""
        return sum(self.logprobs) / len(self.logprobs) if self.logprobs else None


def _token_logprobs(choice: dict[str, Any]) -> list[float]:
    """In the completions' form, a list of numbers, or the chats', a list of objects [nat]."""
    told = choice.get("logprobs")
    if not isinstance(told, dict):
        return []
    values = told.get("token_logprobs")
    if values is None:
        entries = told.get("content") or []
        values = [entry.get("logprob") for entry in entries if isinstance(entry, dict)]
    return [float(value) for value in values if isinstance(value, int | float)]
