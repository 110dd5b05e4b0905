"""A model run in this process by llama.cpp, on the processor alone."""

import importlib
import logging
import os
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import Completion, CompletionRequest, LanguageModel, OnText
from app.llm.backend import PROCESS_ENVIRONMENT, LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.slots import Slots
from app.llm.sources import weight_store
from app.llm.weights import WeightFile

BATCH = 128
"""Tokens of a prompt read between two chances to cancel."""
SILENT, TALKATIVE = 0, 3
"""How much the library writes to standard error."""

log = logging.getLogger(__name__)


class LocalModel:
    """One loaded model with one slot: requests wait for one another."""

    follows_grammar = True

    def __init__(
        self, path: Path, name: str, config: LlmConfig, identity: str, adapter: Path | None = None
    ) -> None:
        """Load the file, which takes seconds and, for 1.5 B weights, 1.9 GB of memory.

        Args:
            path: The verified file of weights.
            name: What completions say they come from.
            config: Threads, context and cache.
            identity: Changes when the file does; states are saved under it.
            adapter: A LoRA adapter (GGUF) for exactly this file, in force from the start.

        Raises:
            ModelUnavailable: the library is absent or cannot load the file.
        """
        self.name = name
        self._context = config.context
        self._lock = threading.Lock()
        library = import_library()
        # The library serves HTTP beside our calls: on a socket that only this user can open.
        self._private = tempfile.TemporaryDirectory(prefix="progprompt-")
        socket = Path(self._private.name) / "llm.sock"
        slots_folder = config.cache / "slots"
        slots_folder.mkdir(parents=True, exist_ok=True)
        params = library.CommonParams()
        params.model.path = str(path)
        params.n_ctx = config.context
        params.n_parallel = 1  # the context would be divided among slots
        params.n_batch = BATCH
        params.cpuparams.n_threads = config.threads
        params.cpuparams_batch.n_threads = config.threads
        params.cache_ram_mib = 0  # one slot, and its state on disk
        params.warmup = False
        params.hostnames = [str(socket)]
        params.slot_save_path = f"{slots_folder}{os.sep}"
        params.verbosity = TALKATIVE if log.isEnabledFor(logging.DEBUG) else SILENT
        params.ui = False
        if adapter is not None:
            lora = library.CommonAdapterLoraInfo()
            lora.path, lora.scale = str(adapter), 1.0
            params.lora_adapters = [lora]
        try:
            self._server = library.Server(params)
        except RuntimeError as error:
            self._private.cleanup()
            raise ModelUnavailable(f"{path} could not be loaded: {error}") from error
        version = getattr(library, "__version__", "")
        self._slots = Slots(socket, slots_folder, f"{identity} {version} {config.context}")

    def close(self) -> None:
        """Give the memory back; the model completes nothing afterwards."""
        with self._lock:
            self._slots.close()
            del self._server
            self._private.cleanup()

    def complete(self, request: CompletionRequest, on_text: OnText | None = None) -> Completion:
        """Continue the prompt; ``on_text`` also gets "" now and then while the prompt is read."""
        started = time.perf_counter()
        with self._lock:
            self._slots.prepare(request.prompt)
            stream = self._ask(request, on_text)
        if stream.raised is not None:
            raise stream.raised
        if stream.error:
            raise CompletionFailed(self._explain(stream.error))
        return Completion(
            text=stream.text,
            model=self.name,
            finish=stream.finish,
            prompt_tokens=stream.prompt_tokens,
            completion_tokens=stream.completion_tokens,
            seconds=time.perf_counter() - started,
        )

    def warm(self, prefix: str) -> bool:
        """Have the state after ``prefix`` at hand, from now on and after a restart.

        Prompts that begin with a prefix warmed once skip reading it. Returns whether the state
        was found on disk; if not, the prefix has now been read and its state was saved.
        """
        with self._lock:
            if self._slots.restore(prefix):
                return True
            stream = self._ask(CompletionRequest(prompt=prefix, max_tokens=0))
            if stream.error:
                raise CompletionFailed(self._explain(stream.error))
            self._slots.save(prefix)
            return False

    def _ask(self, request: CompletionRequest, on_text: OnText | None = None) -> "_Stream":
        body: dict[str, object] = {
            "prompt": request.prompt,
            "max_tokens": request.max_tokens,
            "temperature": request.temperature,
            "seed": request.seed,
            "stop": list(request.stop),
            "cache_prompt": True,
            "stream": True,
            "stream_options": {"include_usage": True},
            "return_progress": True,
        }
        if request.grammar:
            body["grammar"] = request.grammar
        stream = _Stream(on_text)
        self._server.handle_completions(body, stream)
        self._slots.holds(request.prompt)
        return stream

    def _explain(self, error: dict[str, Any]) -> str:
        if error.get("type") == "exceed_context_size_error":
            return (
                f"the prompt has {error.get('n_prompt_tokens')} tokens and {self.name} takes"
                f" {self._context} with the completion; use fewer objects or examples"
            )
        return f"{self.name} refused the request: {error.get('message', error)}"


@backends.register("local")
class LocalBackend:
    """Finds the weights, fetching them if the settings allow it, and loads them."""

    def open(self, spec: ModelSpec, config: LlmConfig) -> LanguageModel:
        """The model, loaded."""
        weights = spec.weights
        if weights is None:
            raise ModelUnavailable(f"{spec.name} has no file of weights")
        path = _file(spec.name, weights, config)
        return LocalModel(path, spec.name, config, weights.sha256)


def _file(name: str, weights: WeightFile, config: LlmConfig) -> Path:
    store = weight_store(config)
    if not config.fetch and store.status(weights) != "present":
        raise ModelUnavailable(
            f"the weights of {name} are not at {store.path(weights)};"
            f" run: progprompt models fetch {name}"
        )
    return store.ensure(weights)


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


class _Stream:
    """Takes the chunks of one completion; carries exceptions out, which the library swallows."""

    def __init__(self, on_text: Callable[[str], bool] | None) -> None:
        self._on_text = on_text
        self.text = ""
        self.finish: Literal["stop", "length", "cancelled"] = "stop"
        self.prompt_tokens = 0
        self.completion_tokens = 0
        self.error: dict[str, Any] = {}
        self.raised: BaseException | None = None

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
        if choice.get("finish_reason") == "length":
            self.finish = "length"
        if usage := chunk.get("usage"):
            self.prompt_tokens = usage["prompt_tokens"]
            self.completion_tokens = usage["completion_tokens"]
        elif self._on_text and (new or progress) and self._on_text(new):
            self.finish = "cancelled"
            return True
        return False
