"""SayCan: the model scores every admissible action, the world says which can be done.

After Ahn et al., with the world's perfect executor as the affordance: 1 where the action's
preconditions hold in the state that the steps so far would bring about, and it changes something
there; else 0.
"""

from collections.abc import Iterator

from app.domain.errors import ActionFailure, ModelUnavailable
from app.domain.llm import LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import ActionCall, Pass, Program
from app.domain.world import World
from app.llm.matching import likeliest_names, ranked
from app.planners import planners
from app.programs.printer import print_program
from app.programs.transcript import Transcript
from app.programs.wording import DONE, all_calls, numbered, say, spoken_examples, spoken_prompt

MOST_STEPS = 20
MOST_OBJECTS = 12
"""Objects whose actions are scored, at most: those the instruction names, then the nearest."""


@planners.register("saycan")
class SayCan:
    """Never asks for text: the next step is the likeliest of those that can be done."""

    model = "qwen2.5-coder-1.5b"
    repairs = False

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Have the model score one step after the other.

        Raises:
            ModelError: the model could not be asked, or does not tell probabilities.
            Cancelled: ``report`` asked for it.
        """
        if task.rehearsal is None:
            raise ModelUnavailable("SayCan weighs what the world allows, and no world was given")
        world = task.rehearsal()
        names = likeliest_names(task.instruction.text, task.scene.names, MOST_OBJECTS)
        examples = spoken_examples(task, ranked)
        prompt = spoken_prompt(examples, task.instruction.text, names)
        transcript = Transcript(task.options.name, model, prompt, report)
        body: list[ActionCall] = []
        shown = prompt
        for number in range(1, MOST_STEPS + 1):
            calls = list(_possible(world, all_calls(task.scene, task.actions, names)))
            said = [*(say(call, task.actions) for call in calls), DONE]
            scores = model.score(shown, [f" {step}\n" for step in said])
            best = max(range(len(said)), key=scores.__getitem__)
            if best == len(calls):
                break
            transcript.wrote(numbered(number, said[best]))
            shown += numbered(number, said[best])
            body.append(calls[best])
            _do(world, calls[best])
        program = Program(name=task.instruction.function_name, body=tuple(body) or (Pass(),))
        text = print_program(program)
        return Draft(prompt=prompt, completion=transcript.completion(), program=text)


def _possible(world: World, calls: Iterator[ActionCall]) -> Iterator[ActionCall]:
    """Those that can be done as the world stands, and change it; it is left as it was."""
    before = world.save()
    for call in calls:
        try:
            _do(world, call)
        except ActionFailure:
            continue
        if world.save() != before:
            yield call
            world.restore(before)


def _do(world: World, call: ActionCall) -> None:
    for _ in world.perform(call.action, call.arguments):
        pass
