"""Settings: the environment, read once and typed.

Every setting is an environment variable ``PROGPROMPT_<FIELD>`` named after the field below, so
``PROGPROMPT_DATA_DIR=/srv/progprompt`` sets ``data_dir``. An empty variable counts as not set.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, get_type_hints

PREFIX = "PROGPROMPT_"


class SettingRefused(ValueError):
    """A variable of the environment does not have the form its setting wants."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """All there is to configure."""

    host: str = "127.0.0.1"
    """Address the service listens on; loopback unless somebody decides otherwise."""
    port: int = 8000
    data_dir: Path | None = None
    """Where everything is kept; default ``$XDG_DATA_HOME/progprompt``, that is
    ``~/.local/share/progprompt``, so it does not depend on where the command is typed."""
    database_url: str | None = None
    """SQLAlchemy URL; default a SQLite file in ``data_dir``."""
    cache: Path | None = None
    """Where model weights are kept; default the user's cache folder."""
    model: str = "default"
    """The model that a plan's ``default`` stands for, and that is loaded at start."""
    model_path: Path | None = None
    """A model file, or a folder of such, that goes before the cache; the checksum decides."""
    threads: int = 2
    """Threads of the embedded model."""
    endpoint_url: str | None = None
    """Base URL of an OpenAI-compatible endpoint, like ``http://127.0.0.1:8080/v1``."""
    endpoint_key: str | None = None
    endpoint_model: str | None = None
    """The model's name at that endpoint."""
    endpoint_chat: bool = False
    """It only takes chats."""
    endpoint_grammar: bool = False
    """It takes a grammar beside the prompt, as the llama.cpp server does."""
    vision_url: str | None = None
    """Base URL of an OpenAI-compatible endpoint whose model takes pictures."""
    vision_key: str | None = None
    vision_model: str | None = None
    """The model's name there; plans reach it by ``"perception": {"detector": "vision"}``."""
    anthropic_key: str | None = None
    anthropic_model: str | None = None
    """The model that plans get as ``anthropic``."""
    anthropic_url: str = "https://api.anthropic.com/v1"
    """Base URL, where it is not Anthropic's own."""
    most_models: int = 2
    """Local models kept open at the same time; the one longest unused is closed for another."""
    scripted: Path | None = None
    """File of canned completions for the model ``scripted``."""
    household_data: Path | None = None
    """A folder with the graphs ``env0.json`` … that the household's environments then stand for."""
    planning_workers: int = 1
    simulation_workers: int = 1

    @classmethod
    def from_environment(cls, environment: Mapping[str, str] | None = None) -> "Settings":
        """Read the environment.

        Raises:
            SettingRefused: a variable does not have the form its setting wants; it is named.
        """
        given = os.environ if environment is None else environment
        hints = get_type_hints(cls)
        values: dict[str, Any] = {}
        for setting in fields(cls):
            variable = PREFIX + setting.name.upper()
            if text := given.get(variable, "").strip():
                values[setting.name] = _convert(variable, text, hints[setting.name])
        return cls(**values)

    def to_environment(self) -> dict[str, str]:
        """The variables that give these settings again, for the processes we start."""
        values = {setting.name: getattr(self, setting.name) for setting in fields(self)}
        return {
            PREFIX + name.upper(): str(value) for name, value in values.items() if value is not None
        }

    @property
    def data(self) -> Path:
        """The data directory, absolute."""
        base = os.environ.get("XDG_DATA_HOME") or "~/.local/share"
        return (self.data_dir or Path(base) / "progprompt").expanduser().absolute()

    @property
    def database(self) -> str:
        """The database's URL."""
        return self.database_url or f"sqlite:///{self.data / 'progprompt.sqlite'}"


def _convert(variable: str, text: str, hint: object) -> object:
    if hint is int:
        try:
            return int(text)
        except ValueError:
            raise SettingRefused(f"{variable} is {text!r}; a whole number is wanted") from None
    if hint is bool:
        if text.lower() not in ("true", "false"):
            raise SettingRefused(f"{variable} is {text!r}; true or false is wanted")
        return text.lower() == "true"
    return Path(text) if hint == Path | None else text
