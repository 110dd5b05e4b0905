"""LanguageModel: text in, text out."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, Protocol

OnText = Callable[[str], bool]
"""Called with every new piece of the completion; True stops the generation."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CompletionRequest:
    """What a model is asked to continue, and how."""

    prompt: str
    max_tokens: int = 600
    stop: tuple[str, ...] = ()
    temperature: float = 0.0
    seed: int = 0
    grammar: str | None = None
    """A GBNF grammar the completion must follow; backends that cannot are told by its absence."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Completion:
    """What the model wrote."""

    text: str
    model: str
    """The model's own name, as recorded with the plan."""
    finish: Literal["stop", "length", "cancelled"]
    prompt_tokens: int
    completion_tokens: int
    seconds: float
    """Wall time of the whole request [s]."""


class LanguageModel(Protocol):
    """Something that continues a text."""

    name: str
    follows_grammar: bool
    """Whether ``CompletionRequest.grammar`` binds it."""

    def complete(self, request: CompletionRequest, on_text: OnText | None = None) -> Completion:
        """Continue the prompt.

        Raises:
            ModelUnavailable: it cannot be asked.
            CompletionFailed: it was asked and what came back is unusable.
        """
        ...
