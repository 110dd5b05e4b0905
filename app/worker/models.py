"""Models: the language models a planning worker holds open."""

from app.domain.llm import LanguageModel
from app.llm.backend import Warmable
from app.llm.models import LlmConfig, find_model, open_model


class Models:
    """Opens a model at its first use and keeps it, since loading takes seconds."""

    def __init__(self, config: LlmConfig, default: str) -> None:
        self._config = config
        self._default = default
        self._open: dict[str, LanguageModel] = {}

    def __call__(self, name: str) -> LanguageModel:
        """The model of this name; ``default`` is the one the settings name.

        Raises:
            UnknownName: there is no such model.
            ModelUnavailable: it cannot be had; the message says what to do.
        """
        chosen = find_model(self._default if name == "default" else name, self._config).name
        if chosen not in self._open:
            self._open[chosen] = open_model(chosen, self._config)
        return self._open[chosen]

    def load_default(self) -> str:
        """Open the default model; what it is called."""
        return f"holds {self('default').name}"

    def warm_default(self, preamble: str) -> str:
        """Have the default model read what all prompts begin with, where that can be kept.

        Without it the first plan after a start reads some hundred tokens that never change.
        """
        model = self("default")
        if not isinstance(model, Warmable):
            return "has nothing to warm"
        return "remembers its preamble" if model.warm(preamble) else "has read its preamble"
