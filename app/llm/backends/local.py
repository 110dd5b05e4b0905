"""A model run in this process by llama.cpp, on the processor alone."""

import logging
import os
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import Completion, CompletionRequest, LanguageModel, OnText
from app.llm.adapters import check
from app.llm.backend import LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.llama import Stream, import_library
from app.llm.scoring import score_sequences
from app.llm.slots import Slots
from app.llm.sources import weight_store
from app.llm.weights import WeightFile

BATCH_BYTES = 16e9
"""Bytes of weights times tokens of a prompt, read between two chances to cancel: at 128 tokens those
who cancelled waited for seconds. 32 tokens for the 0.5 B cost 16 % more CPU than that."""
MOST_PROBABLE = 1000
"""Of the next token's probabilities, that many are told when scoring."""
SILENT, TALKATIVE = 0, 3
"""How much the library writes to standard error."""

log = logging.getLogger(__name__)


class LocalModel:
    """One loaded model with one slot: requests wait for one another."""

    follows_grammar = True

    def __init__(
        self,
        path: Path,
        name: str,
        config: LlmConfig,
        identity: str,
        adapter: Path | None = None,
        drafts: Path | None = None,
    ) -> None:
        """Load the file, which takes seconds and, for 1.5 B weights, 1.9 GB of memory.

        Args:
            path: The verified file of weights.
            name: What completions say they come from.
            config: Threads, context and cache.
            identity: Changes when the file does; states are saved under it.
            adapter: A LoRA adapter (GGUF) for exactly this file, in force from the start.
            drafts: What usually follows in what it writes (``app.llm.drafts``). It writes faster
                with them, and tells no log-probabilities of a completion.

        Raises:
            ModelUnavailable: the library is absent or cannot load the file.
        """
        self.name = name
        self._context = config.context
        self._tells_logprob = drafts is None  # The library tells none of tokens it foresaw.
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
        params.n_batch = config.batch or _batch(path)
        params.cpuparams.n_threads = config.threads
        params.cpuparams_batch.n_threads = config.threads
        params.cache_ram_mib = 0  # one slot, and its state on disk
        params.fit_params = False  # It would read the vocabulary twice.
        params.warmup = False
        params.hostnames = [str(socket)]
        params.slot_save_path = f"{slots_folder}{os.sep}"
        params.verbosity = TALKATIVE if log.isEnabledFor(logging.DEBUG) else SILENT
        params.ui = False
        if adapter is not None:
            lora = library.CommonAdapterLoraInfo()
            lora.path, lora.scale = str(adapter), 1.0
            params.lora_adapters = [lora]
        if drafts is not None:
            foreseeing = library.common_speculative_type.COMMON_SPECULATIVE_TYPE_NGRAM_CACHE
            params.speculative.types = [foreseeing]
            params.speculative.ngram_cache.lookup_cache_static = str(drafts)
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
            logprob=stream.mean_logprob,
        )

    def warm(self, prefix: str) -> bool:
        """Have the state after ``prefix`` at hand, from now on and after a restart.

        Prompts that begin with a prefix warmed once skip reading it. Returns whether the state
        was found on disk; if not, the prefix has now been read and its state was saved. The
        weights are in memory then, too.
        """
        with self._lock:
            found = self._slots.restore(prefix)
            if not found:
                self._read(prefix, 0)
                self._slots.save(prefix)
            self._read(prefix, 1)
            return found

    def score(self, prompt: str, candidates: Sequence[str]) -> tuple[float, ...]:
        """The candidates' log-probabilities [nat], told apart where their tokens branch.

        Exact there for the ``MOST_PROBABLE`` likeliest tokens; rarer ones all get the least of
        those values. What does not tell candidates apart counts as certain.
        """
        with self._lock:
            sequences = self._slots.tokens([prompt + candidate for candidate in candidates])
            self._slots.prepare(prompt)
            scores = score_sequences(sequences, self._next_token)
            self._slots.holds(prompt)
            return scores

    def _read(self, prompt: str, tokens: int) -> None:
        stream = self._ask(CompletionRequest(prompt=prompt, max_tokens=tokens))
        if stream.error:
            raise CompletionFailed(self._explain(stream.error))

    def _next_token(self, tokens: tuple[int, ...]) -> dict[int, float]:
        """Log-probabilities of the likeliest tokens after these [nat]."""
        body = {
            "prompt": list(tokens),
            "max_tokens": 1,
            "n_probs": MOST_PROBABLE,
            "temperature": 0.0,
            "cache_prompt": True,
        }
        answers: list[dict[str, Any]] = []
        self._server.handle_completions(body, lambda answer: bool(answers.append(answer)))
        if not answers or "error" in answers[0]:
            error = answers[0]["error"] if answers else {"message": "no answer"}
            raise CompletionFailed(self._explain(error))
        (said,) = answers[0]["choices"][0]["logprobs"]["content"]
        return {entry["id"]: entry["logprob"] for entry in said["top_logprobs"]}

    def _ask(self, request: CompletionRequest, on_text: OnText | None = None) -> Stream:
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
        if request.logprob and self._tells_logprob:
            body["n_probs"] = 1
        stream = Stream(on_text)
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
        adapter = spec.adapter
        if adapter is not None:
            check(adapter, weights.sha256)
        path = _file(spec.name, weights, config)
        if adapter is None:
            return LocalModel(path, spec.name, config, weights.sha256)
        identity = f"{weights.sha256} {adapter.sha256}"
        return LocalModel(path, spec.name, config, identity, adapter.path, adapter.drafts)


def _batch(path: Path) -> int:
    """Tokens: 32 for 0.5 B weights, 14 for 1.5 B."""
    size = path.stat().st_size if path.exists() else 0
    return max(8, min(128, int(BATCH_BYTES / max(size, 1))))


def _file(name: str, weights: WeightFile, config: LlmConfig) -> Path:
    store = weight_store(config)
    if not config.fetch and store.status(weights) != "present":
        raise ModelUnavailable(
            f"the weights of {name} are not at {store.path(weights)};"
            f" run: progprompt models fetch {name}"
        )
    return store.ensure(weights)
