"""The paper's planner: prompt → completion → program."""

import re
import time
from collections.abc import Sequence
from dataclasses import replace

from app.domain.action import ActionSignature
from app.domain.errors import Cancelled, CompletionFailed, ProgramRefused
from app.domain.llm import Completion, CompletionRequest, LanguageModel
from app.domain.planner import Draft, PlannerOptions, Report, Task
from app.domain.trace import (
    CompletionContinued,
    CompletionGrew,
    PlanningEvent,
    PlanningStarted,
    PromptWritten,
)
from app.llm.embeddings import sentence_embedder
from app.llm.grammar import PLACES, program_grammar
from app.planners import planners
from app.programs.examples import asserted_relations, load_examples
from app.programs.parser import parse_program
from app.programs.prompt import write_cue, write_preamble, write_prompt
from app.programs.repetition import before_repetition
from app.programs.transcript import LOOK_EVERY

STOP = ("\ndef ", "\n\n\n", "\nfrom ", "\nclass ", "\nif __name__", "```")
STOP_CONSTRAINED = ("\n\n", "\ndef ")
"""The grammar has an empty line at its end only."""
MAX_CONTINUATIONS = 2
"""How often a completion that was cut off is gone on with."""
PIECE = 12
"""Characters the completion grows by, at least, before it is told of: a few tokens."""

_FENCE = re.compile(r"\A\s*```\w*\n")
_HEAD = re.compile(r"\A(?:[^\n]*\n)??def \w+\(\):[^\n]*\n(?:[ \t]+objects = [^\n]*\n)?")


@planners.register("progprompt")
class ProgPrompt:
    """Asks for the whole function at once, as the paper does."""

    model = "qwen2.5-coder-1.5b"
    repairs = False

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for the program of this task.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            Cancelled: ``report`` asked for it.
        """
        options = task.options
        telling = _Telling(report)
        telling.event(PlanningStarted(planner=options.name, model=model.name))
        prompt = write_prompt(task, _by_meaning if options.choice == "similar" else None)
        telling.event(PromptWritten(characters=len(prompt)))
        completion = _complete(task, prompt, model, telling)
        program = write_cue(task) + function_body(completion.text)
        if reason := _fault(completion, program):
            raise CompletionFailed(reason, prompt=prompt, completion=completion)
        return Draft(prompt=prompt, completion=completion, program=program)

    def preamble(self, world: str, actions: Sequence[ActionSignature]) -> str:
        """What its prompts begin with, as long as nobody asks for other switches."""
        return write_preamble(world, actions, PlannerOptions())


def _complete(task: Task, prompt: str, model: LanguageModel, telling: "_Telling") -> Completion:
    """Ask for the body, and for the rest of it where the model ran into its limit of tokens."""
    constrained = task.options.constrained and model.follows_grammar
    request = CompletionRequest(
        prompt=prompt,
        max_tokens=task.options.max_tokens,
        stop=STOP_CONSTRAINED if constrained else STOP,
        temperature=task.options.temperature,
        seed=task.options.seed,
        grammar=_grammar(task) if constrained else None,
    )
    completion = telling.ended(model.complete(request, telling.text))
    for _ in range(MAX_CONTINUATIONS):
        kept = whole_lines(completion.text)
        if completion.finish != "length" or not kept:
            break
        telling.event(CompletionContinued(kept=len(kept), tokens=completion.completion_tokens))
        grammar = _grammar(task, begun=True) if constrained else None
        again = replace(request, prompt=prompt + kept, grammar=grammar)
        rest = telling.ended(model.complete(again, telling.text))
        completion = _joined(completion, kept, rest)
    return completion


def whole_lines(text: str) -> str:
    """What of a completion that was cut off can be gone on from: its whole lines.

    An assertion whose recoveries are still to come is left out with them.
    """
    lines = re.findall(r"[^\n]*\n", text)
    while lines and lines[-1].lstrip().startswith("assert"):
        lines.pop()
    return "".join(lines)


def _joined(begun: Completion, kept: str, rest: Completion) -> Completion:
    return replace(
        rest,
        text=kept + rest.text,
        prompt_tokens=begun.prompt_tokens + rest.prompt_tokens,
        completion_tokens=begun.completion_tokens + rest.completion_tokens,
        seconds=begun.seconds + rest.seconds,
    )


def _by_meaning(sentence: str, texts: Sequence[str]) -> Sequence[int]:
    """The places of the texts, the one closest in meaning to the sentence first."""
    vectors = sentence_embedder().embed([sentence, *texts])
    likeness = vectors[1:] @ vectors[0]
    return sorted(range(len(texts)), key=lambda place: (-float(likeness[place]), place))


def function_body(text: str) -> str:
    """The lines of a completion that belong to the function it goes on with.

    It ends where a line is no longer indented. A chat model may wrap it in a fence, and repeat the
    function's head.
    """
    text = _HEAD.sub("", _FENCE.sub("", text.replace("\r\n", "\n")), count=1)
    lines: list[str] = []
    for line in text.split("\n"):
        if line.strip() and line[0] not in " \t":
            break
        lines.append(line.rstrip())
    body = "\n".join(lines).strip("\n")
    return f"{body}\n" if body else ""


def _grammar(task: Task, *, begun: bool = False) -> str:
    options = task.options
    shown = asserted_relations(load_examples(task.scene.world))
    return program_grammar(
        task.scene,
        task.actions,
        comments=options.comments,
        feedback=options.feedback,
        relations=shown or PLACES,
        begun=begun,
        affordances=options.affordances,
    )


def _fault(completion: Completion, program: str) -> str | None:
    """Why nothing can be made of the completion, or None."""
    start = _start(completion.text)
    if not completion.text.strip():
        return f"the model {completion.model} wrote nothing; try another model or wording"
    if completion.finish == "length":
        return (
            f"the model {completion.model} came to no end within {completion.completion_tokens} "
            f"tokens; it began with {start}"
        )
    if not function_body(completion.text):
        return f"the model {completion.model} wrote no plan but {start}"
    try:
        parse_program(program)
    except ProgramRefused as refused:
        return f"what the model {completion.model} wrote is no plan: {refused}"
    return None


def _start(text: str) -> str:
    text = text.strip()
    return repr(text if len(text) <= 80 else f"{text[:80]}…")


class _Telling:
    """Tells of the completion in pieces as it grows; stops it where it runs in circles."""

    def __init__(self, report: Report) -> None:
        self._report = report
        self._pending = ""
        self._told = False
        self._stopping = False
        self._written = ""
        self._kept: str | None = None
        self._looked = time.perf_counter()

    def event(self, event: PlanningEvent) -> None:
        """Tell of one event.

        Raises:
            Cancelled: whoever was told asked for it.
        """
        if self._report(event):
            raise Cancelled("planning was cancelled")

    def text(self, piece: str) -> bool:
        """Take a new piece of the completion; True stops the generation."""
        self._pending += piece
        self._written += piece
        if "\n" in piece:
            self._kept = before_repetition(self._written)
        # Also while nothing is written, since the prompt is still being read, one may cancel.
        due = time.perf_counter() - self._looked >= LOOK_EVERY
        if not self._stopping and (len(self._pending) >= PIECE or "\n" in piece or due):
            self._looked = time.perf_counter()
            self._stopping = self._report(CompletionGrew(text=self._pending))
            self._told = self._told or bool(self._pending)
            self._pending = ""
        return self._stopping or self._kept is not None

    def ended(self, completion: Completion) -> Completion:
        """Tell of what is left of the completion; where it ran in circles, of one round only.

        Raises:
            Cancelled: whoever was told asked for it.
        """
        kept, self._written, self._kept = self._kept, "", None
        if self._stopping or (completion.finish == "cancelled" and kept is None):
            raise Cancelled("planning was cancelled")
        rest = self._pending if self._told else self._pending or completion.text
        self._pending, self._told = "", False
        if rest:
            self.event(CompletionGrew(text=rest))
        if kept is None:
            return completion
        self.event(CompletionContinued(kept=len(kept), tokens=completion.completion_tokens))
        return replace(completion, text=kept, finish="stop")
