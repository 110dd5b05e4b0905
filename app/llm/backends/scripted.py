"""Canned completions: a first-class backend, for tests and for showing the service off-line."""

import json
import re
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from itertools import chain, cycle, repeat, takewhile
from pathlib import Path
from typing import Literal

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import Completion, CompletionRequest, LanguageModel, OnText
from app.llm.backend import LlmConfig, ModelSpec
from app.llm.backends import backends


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """One canned completion."""

    text: str = ""
    when: str = ""
    """Given where the prompt's last function holds these words; empty: always."""
    endless: bool = False
    """The text again and again, until cancelled or out of tokens."""
    delay: float = 0.0
    """Before every piece [s]."""
    error: str = ""
    """Raise ``CompletionFailed`` with this message once the text is out."""


Script = Sequence[Answer] | Callable[[str], Answer]
"""The first answer whose ``when`` fits; or a function of the prompt."""


class ScriptedModel:
    """Answers from a script, word by word; a word counts as a token."""

    follows_grammar = False

    def __init__(self, script: Script, name: str = "scripted") -> None:
        self.name = name
        self._script = script

    def complete(self, request: CompletionRequest, on_text: OnText | None = None) -> Completion:
        """Give the answer that fits the prompt."""
        started = time.perf_counter()
        answer = self._answer(request.prompt)
        pieces = re.findall(r"\s*\S+|\s+", answer.text)
        text, count = "", 0
        finish: Literal["stop", "length", "cancelled"] = "stop"
        for piece in chain(pieces, _more(answer, pieces)):
            if count >= request.max_tokens:
                finish = "length"
                break
            time.sleep(answer.delay)
            count += 1
            grown = _before_stop(text + piece, request.stop)
            stopped = grown != text + piece
            new, text = grown[len(text) :], grown
            if new and on_text and on_text(new):
                finish = "cancelled"
                break
            if stopped:
                break
        if answer.error:
            raise CompletionFailed(answer.error)
        return Completion(
            text=text,
            model=self.name,
            finish=finish,
            prompt_tokens=len(request.prompt.split()),
            completion_tokens=count,
            seconds=time.perf_counter() - started,
            logprob=0.0 if request.logprob else None,
        )

    def score(self, prompt: str, candidates: Sequence[str]) -> tuple[float, ...]:
        """Certain (0) where the script goes on so; each character beyond that costs 1 [nat].

        What of the answer the prompt ends with already is taken as written.
        """
        answer = self._answer(prompt)
        if answer.error:
            raise CompletionFailed(answer.error)
        rest = answer.text[_written(prompt, answer.text) :]
        return tuple(float(-_beyond(rest, candidate)) for candidate in candidates)

    def _answer(self, prompt: str) -> Answer:
        if callable(self._script):
            return self._script(prompt)
        asked = _words(prompt[max(0, prompt.rfind("def ")) :])
        for answer in self._script:
            if _words(answer.when) in asked:
                return answer
        raise CompletionFailed("the script has no answer for this prompt")


@backends.register("scripted")
class ScriptedBackend:
    """Reads the script that the settings name; without one it opens, but has no answer."""

    def open(self, spec: ModelSpec, config: LlmConfig) -> LanguageModel:
        """The model that answers from ``config.scripted_file``."""
        if config.scripted_file is None:
            return ScriptedModel(_no_script, spec.name)
        return ScriptedModel(read_script(config.scripted_file), spec.name)


def _no_script(prompt: str) -> Answer:
    del prompt  # Unused.
    raise ModelUnavailable("the scripted model needs a file of answers in the settings")


def read_script(path: Path) -> tuple[Answer, ...]:
    """The answers in a JSON file: a list of objects with the fields of ``Answer``.

    Raises:
        ModelUnavailable: the file cannot be read or has another form.
    """
    try:
        entries = json.loads(path.read_text())
    except (OSError, ValueError) as error:
        raise ModelUnavailable(f"the script {path} cannot be read: {error}") from error
    if not isinstance(entries, list):
        raise ModelUnavailable(f"the script {path} is not a list of answers")
    return tuple(_read_answer(entry, f"{path}, answer {n}") for n, entry in enumerate(entries))


def _read_answer(entry: object, place: str) -> Answer:
    known = [field.name for field in fields(Answer)]
    if not isinstance(entry, dict) or not set(entry) <= set(known):
        raise ModelUnavailable(f"{place}: an object with some of {', '.join(known)} is wanted")
    defaults = Answer()
    for name, value in entry.items():
        wanted = (int, float) if name == "delay" else type(getattr(defaults, name))
        if not isinstance(value, wanted):
            raise ModelUnavailable(f"{place}: {name} is {value!r}, which is of the wrong type")
    return Answer(**entry)


def _more(answer: Answer, pieces: list[str]) -> Iterator[str]:
    if not answer.endless:
        return iter(())
    return cycle(pieces) if pieces else repeat(" ")


def _before_stop(text: str, stop: tuple[str, ...]) -> str:
    ends = [text.index(word) for word in stop if word in text]
    return text[: min(ends)] if ends else text


def _written(prompt: str, answer: str) -> int:
    """How many characters of the answer the prompt ends with."""
    longest = range(min(len(prompt), len(answer)), 0, -1)
    return next((length for length in longest if prompt.endswith(answer[:length])), 0)


def _beyond(text: str, candidate: str) -> int:
    """How many characters the candidate has from where it leaves the text on."""
    pairs = zip(text, candidate, strict=False)
    alike = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
    return len(candidate) - alike


def _words(text: str) -> str:
    """Sentence and function name alike: ``put the cup`` and ``put_the_cup`` become the same."""
    return re.sub(r"[\W_]+", " ", text.lower()).strip()
