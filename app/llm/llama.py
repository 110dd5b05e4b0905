"""The library llama.cpp in this process: how it is imported, and how its chunks are taken."""

import importlib
import logging
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

from app.domain.errors import ModelUnavailable
from app.llm.backend import PROCESS_ENVIRONMENT

log = logging.getLogger(__name__)


def import_library() -> ModuleType:
    """The library, with the environment it wants.

    Raises:
        ModelUnavailable: it is not installed, or a system library that it needs is not.
    """
    for name, value in PROCESS_ENVIRONMENT.items():
        if os.environ.get(name) != value and _thread_library_loaded():
            log.warning(
                "the thread library is loaded already: start this process with %s=%s,"
                " or completions will be slow on a busy machine",
                name,
                value,
            )
        os.environ[name] = value
    try:
        return importlib.import_module("xllamacpp")
    except ModuleNotFoundError as error:
        raise ModelUnavailable(
            "the embedded model needs the extra 'local': pip install 'progprompt[local]'"
        ) from error
    except ImportError as error:
        raise ModelUnavailable(
            f"the embedded model cannot start: {error} (on Debian, libgomp is in libgomp1)"
        ) from error


def _thread_library_loaded() -> bool:
    maps = Path("/proc/self/maps")
    return "xllamacpp" in sys.modules or (maps.exists() and "libgomp" in maps.read_text())


class Stream:
    """Takes the chunks of one completion; carries exceptions out, which the library swallows."""

    def __init__(self, on_text: Callable[[str], bool] | None) -> None:
        self._on_text = on_text
        self.text = ""
        self.logprobs: list[float] = []
        self.finish: Literal["stop", "length", "cancelled"] = "stop"
        self.prompt_tokens = 0
        self.completion_tokens = 0
        self.error: dict[str, Any] = {}
        self.raised: BaseException | None = None

    @property
    def mean_logprob(self) -> float | None:
        """Over the tokens written [nat], where it was asked for."""
        return sum(self.logprobs) / len(self.logprobs) if self.logprobs else None

    def __call__(self, chunk: dict[str, Any]) -> bool:
        """True ends the completion."""
        try:
            return self._take(chunk)
        except BaseException as error:
            self.raised = error
            return True

    def _take(self, chunk: dict[str, Any]) -> bool:
        if "error" in chunk:
            self.error = chunk["error"]
            return True
        if progress := chunk.get("prompt_progress"):
            self.prompt_tokens = progress["total"]
        choice = chunk["choices"][0] if chunk.get("choices") else {}
        new = choice.get("text", "")
        self.text += new
        self.completion_tokens += bool(new)
        told = (choice.get("logprobs") or {}).get("content") or []
        self.logprobs += [entry["logprob"] for entry in told]
        if choice.get("finish_reason") == "length":
            self.finish = "length"
        if usage := chunk.get("usage"):
            self.prompt_tokens = usage["prompt_tokens"]
            self.completion_tokens = usage["completion_tokens"]
        elif self._on_text and (new or progress) and self._on_text(new):
            self.finish = "cancelled"
            return True
        return False
