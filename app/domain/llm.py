"""LanguageModel: text in, text out."""

from collections.abc import Callable, Sequence
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
    logprob: bool = False
    """Whether the completion is to tell its mean log-probability, where the backend can."""


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
    logprob: float | None = None
    """Mean log-probability of the tokens written [nat], where it was asked for and is told."""


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

    def score(self, prompt: str, candidates: Sequence[str]) -> tuple[float, ...]:
        """How likely each candidate is as the continuation of the prompt: log-probabilities [nat].

        They are there to be compared with one another; where no other candidate goes on
        differently, a backend may take what follows as certain. Of two candidates one of which
        begins with the other the shorter is never less likely, so end them alike.

        Raises:
            ModelUnavailable: it cannot be asked, or its service does not tell probabilities.
            CompletionFailed: it was asked and what came back is unusable.
        """
        ...
