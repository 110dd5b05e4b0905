"""Transcript: what a planner that asks its model more than once was answered, told as it grows."""

import time

from app.domain.errors import Cancelled, CompletionFailed
from app.domain.llm import Completion, CompletionRequest, LanguageModel
from app.domain.planner import PlannerOptions, Report
from app.domain.trace import CompletionGrew, PlanningStarted, PromptWritten

MAX_SKETCH = 300
"""Tokens."""
LOOK_EVERY = 0.2
"""How often is asked whether to stop, while nothing is there to be told [s]."""


class Transcript:
    """Of one plan. Every method raises ``Cancelled`` once ``report`` asked for it."""

    def __init__(self, planner: str, model: LanguageModel, prompt: str, report: Report) -> None:
        self.prompt = prompt
        self._model = model
        self._report = report
        self._text = ""
        self._tokens = [0, 0]
        self._started = self._looked = time.perf_counter()
        self._tell(PlanningStarted(planner=planner, model=model.name))
        self._tell(PromptWritten(characters=len(prompt)))

    def ask(self, request: CompletionRequest) -> Completion:
        """The model's answer, which is not taken as part of the plan yet."""
        completion = self._model.complete(request, self._look)
        self._tokens[0] += completion.prompt_tokens
        self._tokens[1] += completion.completion_tokens
        if completion.finish == "cancelled":
            raise Cancelled("planning was cancelled")
        return completion

    def wrote(self, text: str) -> None:
        """This much more of the plan stands."""
        self._text += text
        self._tell(CompletionGrew(text=text))

    def completion(self) -> Completion:
        """All that stands, as one completion."""
        return Completion(
            text=self._text,
            model=self._model.name,
            finish="stop",
            prompt_tokens=self._tokens[0],
            completion_tokens=self._tokens[1],
            seconds=time.perf_counter() - self._started,
        )

    def failure(self, reason: str) -> CompletionFailed:
        """The error that keeps what came so far."""
        return CompletionFailed(reason, prompt=self.prompt, completion=self.completion())

    def _look(self, piece: str) -> bool:
        del piece  # Told once it is part of the plan.
        if time.perf_counter() - self._looked < LOOK_EVERY:
            return False
        self._looked = time.perf_counter()
        return self._report(CompletionGrew(text=""))

    def _tell(self, event: PlanningStarted | PromptWritten | CompletionGrew) -> None:
        if self._report(event):
            raise Cancelled("planning was cancelled")


def sketch_request(
    options: PlannerOptions, model: LanguageModel, prompt: str, stop: str, grammar: str
) -> CompletionRequest:
    """What a model is asked for a sketch with, under the grammar where it can follow one."""
    return CompletionRequest(
        prompt=prompt,
        max_tokens=min(options.max_tokens, MAX_SKETCH),
        stop=(stop,),
        temperature=options.temperature,
        seed=options.seed,
        grammar=grammar if options.constrained and model.follows_grammar else None,
    )
