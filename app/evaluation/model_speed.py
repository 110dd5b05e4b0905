"""How fast a language model is on this machine: reading, writing, ending when asked to, scoring."""

import statistics
import threading
import time
from dataclasses import dataclass

from app.domain.errors import ModelUnavailable
from app.domain.llm import CompletionRequest, LanguageModel

LINES = 60
"""Calls in the prompt that is read, about 600 tokens."""
TOKENS = 64
"""Written after it."""
CANDIDATES = 50
CANCELS = 5
"""How often each kind of ending is asked for."""
NAMES = ("apple", "bowl", "cup", "drill", "eraser", "fork", "glass", "hammer", "iron", "jar")


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelSpeed:
    """What was measured of one model; the times of ending are from asking to the model's return."""

    model: str
    read_per_second: float
    """Tokens of a prompt never seen before [1/s]."""
    written_per_second: float
    """Tokens of a completion [1/s]."""
    cancel_writing: tuple[float, float]
    """Median and longest while it writes [s]."""
    cancel_reading: tuple[float, float]
    """Median and longest while it reads a prompt [s]."""
    score_seconds: float | None
    """For ``CANDIDATES`` calls after a prompt that was read before [s]; None where it cannot."""


def bench_model(model: LanguageModel) -> ModelSpeed:
    """Measure one model, loaded already.

    Raises:
        ModelError: it cannot be asked.
    """
    writing = CompletionRequest(prompt="def count():\n    # one, two, three,", max_tokens=400)
    model.complete(CompletionRequest(prompt=writing.prompt, max_tokens=1))
    read, wrote = _speeds(model)
    # Asked for well before a fast model would come to its own end.
    while_writing = [
        _cancelled(model, writing, min(0.5, 80 / max(wrote, 1.0))) for _ in range(CANCELS)
    ]
    while_reading = [
        _cancelled(
            model,
            CompletionRequest(prompt=_calls(LINES, start), max_tokens=1),
            min(0.3, 150 / read),
        )
        for start in range(1, CANCELS + 1)
    ]
    return ModelSpeed(
        model=model.name,
        read_per_second=read,
        written_per_second=wrote,
        cancel_writing=(statistics.median(while_writing), max(while_writing)),
        cancel_reading=(statistics.median(while_reading), max(while_reading)),
        score_seconds=_scored(model),
    )


def _speeds(model: LanguageModel) -> tuple[float, float]:
    """Tokens per second, read and written."""
    begun: list[float] = []
    started = time.perf_counter()

    def note(piece: str) -> bool:
        if piece:
            begun.append(time.perf_counter())
        return False

    request = CompletionRequest(prompt=_calls(LINES, 0), max_tokens=TOKENS)
    done = model.complete(request, note)
    ended = time.perf_counter()
    first = begun[0] if begun else ended
    writing = max(ended - first, 1e-9)
    return done.prompt_tokens / (first - started), max(done.completion_tokens - 1, 0) / writing


def _cancelled(model: LanguageModel, request: CompletionRequest, after: float) -> float:
    """Seconds from asking for the end, so long after the beginning, to the model's return [s]."""
    asked = threading.Event()
    times: list[float] = []

    def ask() -> None:
        times.append(time.perf_counter())
        asked.set()

    timer = threading.Timer(after, ask)
    timer.start()
    model.complete(request, lambda _: asked.is_set())
    returned = time.perf_counter()
    timer.cancel()
    return returned - times[0] if times else 0.0


def _calls(count: int, start: int) -> str:
    """A prompt of so many different calls; another start, another prompt from the first token on."""
    lines = (
        f"put('{NAMES[(start + place) % 10]} {start}', '{NAMES[place * 7 % 10]}')\n"
        for place in range(count)
    )
    return f"# table {start}\n" + "".join(lines)


def _scored(model: LanguageModel) -> float | None:
    prompt = _calls(3, 0) + "put('apple', "
    candidates = [f"'{one} {other}')" for one in NAMES for other in NAMES[: CANDIDATES // 10]]
    try:
        model.score(prompt, candidates[:1])
    except ModelUnavailable:
        return None
    started = time.perf_counter()
    model.score(prompt, candidates)
    return time.perf_counter() - started
