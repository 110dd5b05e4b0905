"""Backend: one way of reaching language models; and what it is told about the one to open."""

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, Protocol, runtime_checkable

from app.domain.llm import LanguageModel
from app.llm.adapters import Adapter
from app.llm.weights import WeightFile

HUB = "https://huggingface.co"
TO_CHAT = (
    "You continue texts, most of them Python programs. Answer with nothing but what follows where"
    " the text breaks off: of a function only the rest of its body, of a list only its next items."
    " No fence, no explanation, nothing of what is already there."
)
"""What a model that only chats is told first; the prompt is then its one message."""
PROCESS_ENVIRONMENT = {"GOMP_SPINCOUNT": "0"}
"""For the process that plans: threads that spin while they wait make a busy machine ten times
slower. It counts only if it is set before the thread library is loaded."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Endpoint:
    """A service: hosted, or a server of one's own."""

    protocol: Literal["openai", "anthropic"] = "openai"
    """Name of the backend that speaks it."""

    base_url: str
    """Up to and including the version: ``http://127.0.0.1:8080/v1``."""
    model: str
    """The model's name there."""
    key: str | None = field(default=None, repr=False)
    chat: bool = False
    """It only takes chats: the prompt goes as one message to ``/chat/completions``."""
    grammar: bool = False
    """It takes a GBNF ``grammar`` beside the prompt, as the llama.cpp server does."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelSpec:
    """One entry of the catalogue of models."""

    name: str
    backend: str
    """Name of the backend that opens it."""
    title: str
    licence: str = ""
    aliases: tuple[str, ...] = ()
    weights: WeightFile | None = None
    adapter: Adapter | None = None
    """In force over the weights from the start."""
    endpoint: Endpoint | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class LlmConfig:
    """What the settings say about language models."""

    cache_dir: Path | None = None
    """Where weights and saved slots lie; None for ``$PROGPROMPT_CACHE`` or the user's cache."""
    model_path: Path | None = None
    """A model file, or a folder of such, that goes before the cache."""
    hub_url: str = HUB
    fetch: bool = True
    """Whether absent weights may be fetched when a model is opened."""
    threads: int = 2
    batch: int | None = None
    """Tokens of a prompt read between two chances to cancel; None for few enough that nobody waits."""
    context: int = 8192
    """Tokens of prompt and completion together."""
    endpoints: tuple[tuple[str, Endpoint], ...] = ()
    """Services by the name under which plans ask for them."""
    most_models: int = 2
    """Local models that one process keeps open; the 1.5 B one takes 1.9 GB, the 0.5 B one 0.8."""
    scripted_file: Path | None = None
    """Canned completions for the model ``scripted``."""

    @property
    def cache(self) -> Path:
        """The cache folder in force."""
        if self.cache_dir is not None:
            return self.cache_dir
        if given := os.environ.get("PROGPROMPT_CACHE"):
            return Path(given)
        base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
        return Path(base) / "progprompt" / "models"


class Backend(Protocol):
    """One way of reaching language models."""

    def open(self, spec: ModelSpec, config: LlmConfig) -> LanguageModel:
        """The model, ready to complete.

        Raises:
            ModelUnavailable: it cannot be had; the message says what to do.
        """
        ...


@runtime_checkable
class Warmable(Protocol):
    """A model that can have the state after a fixed prefix at hand."""

    def warm(self, prefix: str) -> bool:
        """Read ``prefix`` now, or take up its saved state; whether it was saved."""
        ...


@runtime_checkable
class Closable(Protocol):
    """A model that takes memory of this process."""

    def close(self) -> None:
        """Give the memory back; the model completes nothing afterwards."""
        ...
