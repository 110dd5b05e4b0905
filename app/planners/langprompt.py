"""LangPrompt: the paper's baseline that describes objects and plans in plain English.

The paper maps each step to an action with a GPT-2 trained for it; here the step becomes the action
whose wording has the nearest sentence embedding, which needs no training and works in any world.
"""

from app.domain.llm import CompletionRequest, LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import ActionCall, Comment, Pass, Program, Statement
from app.llm.matching import likeliest_names, nearest, ranked
from app.planners import planners
from app.programs.printer import print_program
from app.programs.transcript import Transcript
from app.programs.wording import all_calls, read_steps, say, spoken_examples, spoken_prompt

STOP = ("\n\n", "\nTask:")
FEWEST = 0.5
"""Likeness below which a step is no action."""
MOST_OBJECTS = 8
"""Objects that a step is taken to speak of, at most: those it names, then the nearest."""
MOST_STEPS = 40


@planners.register("langprompt")
class LangPrompt:
    """Asks once for all steps."""

    model = "qwen2.5-coder-1.5b"
    repairs = False

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for the steps, and find the action of each.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            Cancelled: ``report`` asked for it.
        """
        options = task.options
        examples = spoken_examples(task, ranked)
        prompt = spoken_prompt(examples, task.instruction.text, task.scene.names)
        transcript = Transcript(options.name, model, prompt, report)
        request = CompletionRequest(
            prompt=prompt,
            max_tokens=options.max_tokens,
            stop=STOP,
            temperature=options.temperature,
            seed=options.seed,
        )
        completion = transcript.ask(request)
        if not completion.text.strip():
            raise transcript.failure(
                f"the model {model.name} wrote nothing; try another model or wording"
            )
        transcript.wrote(completion.text)
        body: list[Statement] = []
        for step in read_steps(completion.text)[:MOST_STEPS]:
            body += [Comment(text=step), *_action(task, step, body)]
        program = Program(name=task.instruction.function_name, body=tuple(body) or (Pass(),))
        return Draft(prompt=prompt, completion=completion, program=print_program(program))


def _action(task: Task, step: str, before: list[Statement]) -> tuple[ActionCall, ...]:
    """The action that the step says; none where no action does, or the last one is said again."""
    names = likeliest_names(step, task.scene.names, MOST_OBJECTS)
    calls = list(all_calls(task.scene, task.actions, names))
    if not calls:
        return ()
    place, likeness = nearest(step, [say(call, task.actions) for call in calls])
    repeated = bool(before) and before[-1] == calls[place]
    return () if likeness < FEWEST or repeated else (calls[place],)
