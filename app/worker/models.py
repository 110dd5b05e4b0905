"""Models: the language models a planning worker holds open."""

from collections.abc import Callable

from app.domain.llm import LanguageModel
from app.llm.backend import Closable, Warmable
from app.llm.models import LlmConfig, find_model, open_model

OpenNamed = Callable[[str, LlmConfig], LanguageModel]


class Models:
    """Opens a model at its first use and keeps it, since loading takes seconds; so many at most."""

    def __init__(self, config: LlmConfig, default: str, open_named: OpenNamed = open_model) -> None:
        self._config = config
        self._open_named = open_named
        self._default = default
        self._open: dict[str, LanguageModel] = {}  # the one last used last

    def __call__(self, name: str, preferred: str) -> LanguageModel:
        """The model of this name.

        ``default`` is the one the settings name or, where they name none, the ``preferred`` one.

        Raises:
            UnknownName: there is no such model.
            ModelUnavailable: it cannot be had; the message says what to do.
        """
        names = [given for given in (name, self._default) if given != "default"]
        chosen = find_model(names[0] if names else preferred, self._config).name
        model = self._open.pop(chosen, None)
        if model is None:
            self._make_room()
            model = self._open_named(chosen, self._config)
        self._open[chosen] = model
        return model

    def _make_room(self) -> None:
        """Close the models longest unused, of those that take memory here, down to one too few."""
        ours = {name: model for name, model in self._open.items() if isinstance(model, Closable)}
        surplus = len(ours) + 1 - max(self._config.most_models, 1)
        for name, model in list(ours.items())[: max(surplus, 0)]:
            model.close()
            del self._open[name]

    def load(self, preferred: str) -> str:
        """Open the default model; what it is called."""
        return f"holds {self('default', preferred).name}"

    def warm(self, preferred: str, preamble: str) -> str:
        """Have the default model read what its prompts begin with, where that can be kept.

        Without it the first plan after a start reads some hundred tokens that never change.
        """
        model = self("default", preferred)
        if not isinstance(model, Warmable):
            return "has nothing to warm"
        return "remembers its preamble" if model.warm(preamble) else "has read its preamble"
