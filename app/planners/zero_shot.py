"""Zero-shot planner of Huang et al.: free text step by step, each translated to an admissible action.

The example is the one whose task is nearest by sentence embedding. Each next step is sampled several
times; a sample is worth the likeness of the nearest action plus 0.3 times its mean log-probability.
The best one's action joins the prompt, until it is worth less than the cutoff.
"""

from dataclasses import dataclass, replace

from app.domain.errors import ModelUnavailable
from app.domain.llm import CompletionRequest, LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import ActionCall, Pass, Program
from app.llm.matching import likeliest_names, nearest, ranked
from app.planners import planners
from app.programs.printer import print_program
from app.programs.transcript import Transcript
from app.programs.wording import (
    DONE,
    SpokenPlan,
    all_calls,
    numbered,
    say,
    spoken_examples,
    spoken_prompt,
)

SAMPLES = 5
"""Of each step; the authors took 10, from a service. Twice the same text counts once."""
TEMPERATURE = 0.6
"""Of the samples, where the plan's options leave it at 0."""
WEIGHT = 0.3
"""Of the mean log-probability."""
CUTOFF = 0.8
REPEATED = 0.5
"""Taken off where the action is the one before."""
MOST_STEPS = 20
STEP_TOKENS = 24
MOST_EXAMPLES = 100
MOST_OBJECTS = 8
"""Objects that a step is taken to speak of, at most: those it names, then the nearest."""


@planners.register("zero_shot")
class ZeroShot:
    """Knows no objects but those that actions can take."""

    model = "qwen2.5-coder-1.5b"
    repairs = False

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for one step after the other.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            Cancelled: ``report`` asked for it.
        """
        prompt = spoken_prompt(_example(task), task.instruction.text)
        transcript = Transcript(task.options.name, model, prompt, report)
        body: list[ActionCall] = []
        shown = prompt
        for number in range(1, MOST_STEPS + 1):
            best = _best(task, shown, transcript, body)
            if best is None and number == 1:
                raise transcript.failure(f"the model {model.name} wrote nothing; try another model")
            if best is None or best.call is None or best.worth < CUTOFF:
                break
            body.append(best.call)
            transcript.wrote(numbered(number, best.said))
            shown += numbered(number, best.said)
        program = Program(name=task.instruction.function_name, body=tuple(body) or (Pass(),))
        text = print_program(program)
        return Draft(prompt=prompt, completion=transcript.completion(), program=text)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Step:
    """A sample, translated."""

    call: ActionCall | None
    """None to end the plan."""
    said: str
    worth: float


def _example(task: Task) -> tuple[SpokenPlan, ...]:
    """The one whose task is nearest; none where the world has no examples."""
    options = replace(task.options, examples=MOST_EXAMPLES, choice="similar")
    return spoken_examples(replace(task, options=options), ranked)[-1:]


def _best(task: Task, shown: str, transcript: Transcript, body: list[ActionCall]) -> _Step | None:
    """The sample worth most; None where all are empty."""
    samples: dict[str, float] = {}
    for number in range(SAMPLES):
        request = CompletionRequest(
            prompt=shown,
            max_tokens=STEP_TOKENS,
            stop=("\n",),
            temperature=task.options.temperature or TEMPERATURE,
            seed=task.options.seed + 1000 * len(body) + number,
            logprob=True,
        )
        completion = transcript.ask(request)
        if completion.logprob is None:
            raise ModelUnavailable(
                f"{completion.model} does not tell log-probabilities, which this planner weighs;"
                " use a local model that is not adapted, or another service"
            )
        if text := completion.text.strip().rstrip("."):
            samples.setdefault(text, completion.logprob)
    last = body[-1] if body else None
    steps = [_translated(task, text, logprob, last) for text, logprob in samples.items()]
    return max(steps, key=lambda step: step.worth, default=None)


def _translated(task: Task, text: str, logprob: float, last: ActionCall | None) -> _Step:
    names = likeliest_names(text, task.scene.names, MOST_OBJECTS)
    calls = [*all_calls(task.scene, task.actions, names), None]
    said = [say(call, task.actions) if call else DONE for call in calls]
    place, likeness = nearest(text, said)
    repeated = REPEATED if last is not None and calls[place] == last else 0.0
    worth = likeness + WEIGHT * logprob - repeated
    return _Step(call=calls[place], said=said[place], worth=worth)
