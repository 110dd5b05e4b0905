"""Anthropic's Messages API: a chat that is asked to go on with the prompt."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import Completion, CompletionRequest, LanguageModel, OnText
from app.llm.backend import TO_CHAT, Endpoint, LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.transport import Transport, sent_events

VERSION = "2023-06-01"
"""Of the protocol, sent with every request."""
HOTTEST = 1.0
"""A higher temperature is refused."""


class AnthropicModel:
    """One model behind the Messages API."""

    follows_grammar = False

    def __init__(self, endpoint: Endpoint, name: str, transport: Transport) -> None:
        self.name = name
        self._endpoint = endpoint
        self._transport = transport

    def complete(self, request: CompletionRequest, on_text: OnText | None = None) -> Completion:
        """Continue the prompt; streamed where somebody watches."""
        started = time.perf_counter()
        answer = _Answer(request.stop)
        body = self._body(request)
        if on_text is None:
            answer.take_whole(self._transport.post("messages", body))
        else:
            self._watch(body, answer, on_text)
        return Completion(
            text=answer.text,
            model=self.name,
            finish=answer.finish,
            prompt_tokens=answer.prompt_tokens,
            completion_tokens=answer.completion_tokens,
            seconds=time.perf_counter() - started,
        )

    def score(self, prompt: str, candidates: Sequence[str]) -> tuple[float, ...]:
        """It cannot."""
        del prompt, candidates  # Unused.
        raise ModelUnavailable(
            f"{self.name} does not tell probabilities, so it cannot score; use a local model"
        )

    def _watch(self, body: dict[str, object], answer: "_Answer", on_text: OnText) -> None:
        body["stream"] = True
        with self._transport.stream("POST", "messages", body=body) as response:
            for event in sent_events(response):
                new = answer.take(event)
                if new and on_text(new):
                    answer.finish = "cancelled"
                if answer.finish == "cancelled" or answer.ended:
                    return
        raise CompletionFailed(f"{self.name} broke off in the middle of its answer; ask again")

    def _body(self, request: CompletionRequest) -> dict[str, object]:
        body: dict[str, object] = {
            "model": self._endpoint.model,
            "max_tokens": request.max_tokens,
            "temperature": min(request.temperature, HOTTEST),
            "system": TO_CHAT,
            "messages": [{"role": "user", "content": request.prompt}],
        }
        # Words of white space only are refused; the answer is cut at those here.
        if words := [word for word in request.stop if word.strip()]:
            body["stop_sequences"] = words
        return body


@backends.register("anthropic")
class AnthropicBackend:
    """Connects nothing yet: the first request shows whether key and model are good."""

    def open(self, spec: ModelSpec, config: LlmConfig) -> LanguageModel:
        """The model behind ``spec.endpoint``."""
        del config  # Unused.
        endpoint = spec.endpoint
        if endpoint is None:
            raise ModelUnavailable(f"{spec.name} has no endpoint; give its base URL and model")
        if not endpoint.key:
            raise ModelUnavailable(f"{spec.name} needs a key: set PROGPROMPT_ANTHROPIC_KEY")
        headers = {"x-api-key": endpoint.key, "anthropic-version": VERSION}
        transport = Transport(endpoint.base_url.rstrip("/") + "/", headers=headers)
        return AnthropicModel(endpoint, spec.name, transport)


@dataclass(slots=True)
class _Answer:
    """What has come so far."""

    stop: tuple[str, ...]
    text: str = ""
    finish: Literal["stop", "length", "cancelled"] = "stop"
    prompt_tokens: int = 0
    completion_tokens: int = 0
    ended: bool = False

    def take_whole(self, message: dict[str, Any]) -> None:
        """Take a whole message."""
        blocks = message.get("content")
        if not isinstance(blocks, list):
            raise CompletionFailed(f"the answer has no content: {str(message)[:200]}")
        self._count(message.get("usage"))
        for block in blocks:
            self._add(block.get("text") or "")
        self._end(message.get("stop_reason"))

    def take(self, event: dict[str, Any]) -> str:
        """Take an event of the stream; returns the text that is new."""
        match event.get("type"):
            case "message_start":
                self._count((event.get("message") or {}).get("usage"))
            case "content_block_delta":
                return self._add((event.get("delta") or {}).get("text") or "")
            case "message_delta":
                self._count(event.get("usage"))
                self._end((event.get("delta") or {}).get("stop_reason"))
            case "message_stop":
                self.ended = True
            case "error":
                said = event.get("error") or {}
                raise CompletionFailed(
                    f"the service broke off ({said.get('type')}): {said.get('message')}; ask again"
                )
            case _:  # pings, and kinds of events that may come to be
                pass
        return ""

    def _add(self, new: str) -> str:
        """Add what comes before a stop word; after one the answer has ended."""
        whole = self.text + new
        ends = [whole.index(word) for word in self.stop if word in whole]
        grown = whole[: min(ends)] if ends else whole
        new, self.text = grown[len(self.text) :], grown
        self.ended = self.ended or bool(ends)
        return new

    def _count(self, usage: dict[str, Any] | None) -> None:
        """Tokens of the prompt with what was cached of it, and of the answer so far."""
        told = {name: n for name, n in (usage or {}).items() if isinstance(n, int)}
        read = [n for name, n in told.items() if name.endswith("input_tokens")]
        self.prompt_tokens = sum(read) or self.prompt_tokens
        self.completion_tokens = told.get("output_tokens", self.completion_tokens)

    def _end(self, reason: str | None) -> None:
        if reason in ("max_tokens", "model_context_window_exceeded"):
            self.finish = "length"
        if reason == "refusal":
            raise CompletionFailed("the model refuses to answer this prompt; use another model")
